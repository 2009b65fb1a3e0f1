// What is read from a pixel's bits, field by field, against what the shaders read there.
#include "renderer/inspect/stored_bits.h"

#include <set>

#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class StoredBits : public GlTest {};

constexpr glm::ivec2 kSize{64, 36}, kPixels[] = {{32, 30}, {10, 32}, {50, 33}, {33, 20}};

PixelProbe probe(Stage& stage, const Settings& s, glm::ivec2 pixel) {
  stage.renderer.start_probe(s, stage.scene, stage.targets, pixel);
  return stage.renderer.take_probe(stage.targets, true).value();
}

// The probe's field that has the same numbers; several names mean one thing.
struct Meaning {
  const char* name;
  ProbeField field;
};
constexpr Meaning kMeanings[] = {{"albedo", ProbeField::albedo},
                                 {"colour", ProbeField::albedo},
                                 {"diffuse colour", ProbeField::albedo},
                                 {"Kd", ProbeField::albedo},
                                 {"roughness", ProbeField::roughness},
                                 {"specular colour", ProbeField::f0},
                                 {"specular strength", ProbeField::f0},
                                 {"Ks", ProbeField::f0},
                                 {"F0", ProbeField::f0},
                                 {"exponent", ProbeField::exponent},
                                 {"Ns", ProbeField::exponent},
                                 {"Ka", ProbeField::ambient},
                                 {"ambient colour", ProbeField::ambient},
                                 {"metal", ProbeField::metal},
                                 {"occlusion", ProbeField::occlusion},
                                 {"emission", ProbeField::emission},
                                 {"radiance it sends out itself", ProbeField::emission},
                                 {"ambient + emission", ProbeField::emission},
                                 {"number of the object", ProbeField::object},
                                 {"normal", ProbeField::normal},
                                 {"distance", ProbeField::range},
                                 {"position in the world", ProbeField::position},
                                 {"window depth", ProbeField::window_depth},
                                 {"diffuse light without albedo", ProbeField::diffuse_light},
                                 {"specular light", ProbeField::specular_light},
                                 {"linear radiance", ProbeField::lit}};

// Stored for nobody to read, or compared below by hand.
const std::set<std::string> kOwnWays = {
    "unused",  "1",           "padding of RGB8",        "1 where a surface is", "shines",
    "stencil", "base colour", "F0 of what is no metal", "position in the view"};

std::vector<double> meant(const PixelProbe& p, const Camera& camera, const FieldRead& r) {
  for (const Meaning& m : kMeanings)
    if (r.field.name == m.name) {
      const glm::vec4& v = p.values[static_cast<size_t>(m.field)];
      return std::vector<double>{&v.x, &v.x + r.values.size()};
    }
  EXPECT_TRUE(kOwnWays.contains(r.field.name)) << "nobody compares " << r.field.name;
  if (r.field.name == "base colour") {
    const double dielectric = 1 - p.number(ProbeField::metal);
    const glm::dvec3 base = glm::dvec3(p.vector(ProbeField::albedo)) / dielectric;
    if (dielectric > 0.1) return {base.x, base.y, base.z};
  }
  if (r.field.name == "position in the view") {
    const glm::dvec3 relative = glm::dvec3(p.vector(ProbeField::position)) - camera.position;
    const glm::dvec3 view = glm::conjugate(camera.orientation) * relative;
    return {view.x, view.y, view.z};
  }
  return {};
}

// Of the stage's last frame; the names of the fields that were compared.
std::set<std::string> compare(Stage& stage, const Settings& s) {
  std::set<std::string> compared;
  stage.draw(s);
  const Settings& drawn = stage.targets.drawn->settings;
  for (const glm::ivec2 pixel : kPixels) {
    const PixelProbe p = probe(stage, s, pixel);
    EXPECT_TRUE(p.surface());
    for (const StoredTexel& t : p.stored) {
      if (t.attachment.stores == Stores::light_depth) continue;
      for (const FieldRead& r : read_fields(drawn, t)) {
        const std::vector<double> expected = meant(p, drawn.camera, r);
        if (!expected.empty()) compared.insert(r.field.name);
        for (size_t c = 0; c < expected.size(); ++c)
          EXPECT_NEAR(r.values[c], expected[c], 2e-6 * (1 + std::abs(expected[c])))
              << row(drawn.layout).id << " " << row(drawn.normal.encoding).id << " " << t.attachment.name << " "
              << r.field.name << " component " << c;
      }
    }
  }
  return compared;
}

TEST_F(StoredBits, OfEveryLayoutMeanWhatTheShadersRead) {
  std::set<std::string> compared;
  Stage stage(yard());
  Settings s = settings_for(yard(), kSize);
  s.lights.count = 4;
  for (const ValueRow& r : rows<Layout>()) {
    s.layout = static_cast<Layout>(r.value);
    if (s.layout == Layout::auto_) continue;
    compared.merge(compare(stage, s));
  }
  s.layout = Layout::compact_metal, s.colour = Colour::as_tutorial;
  compared.merge(compare(stage, s));
  s.lights.method = LightMethod::prepass;
  compared.merge(compare(stage, s));
  for (const char* name :
       {"albedo", "colour", "diffuse colour", "Kd", "Ks", "Ka", "Ns", "roughness", "exponent", "metal", "occlusion",
        "emission", "base colour", "specular strength", "number of the object", "linear radiance"})
    EXPECT_TRUE(compared.contains(name)) << name;
}

TEST_F(StoredBits, OfEveryNormalAndPositionMeanWhatTheShadersRead) {
  Stage stage(yard());
  Settings s = settings_for(yard(), kSize);
  s.lights.count = 4;
  for (const ValueRow& r : rows<NormalEncoding>()) {
    s.normal.encoding = static_cast<NormalEncoding>(r.value);
    s.normal.space = r.value % 2 ? NormalSpace::view : NormalSpace::world;
    s.layout = s.layout == Layout::compact ? Layout::albedo_roughness : Layout::compact;
    EXPECT_TRUE(compare(stage, s).contains("normal")) << r.id;
  }
  s.normal.encoding = NormalEncoding::oct12;  // in the material, and in an attachment of its own
  for (const Layout layout : {Layout::compact, Layout::albedo_roughness}) {
    s.layout = layout;
    EXPECT_TRUE(compare(stage, s).contains("normal"));
  }
  for (const ValueRow& r : rows<PositionSource>()) {
    s.position.source = static_cast<PositionSource>(r.value);
    EXPECT_TRUE(s.position.source == PositionSource::depth || compare(stage, s).size() > 5) << r.id;
  }
  for (const ValueRow& r : rows<AccumulationFormat>()) {
    s.accumulation.format = static_cast<AccumulationFormat>(r.value);
    s.exposure = r.value % 2 ? 1.0 / 4096 : 1;  // sums are stored in other units there
    EXPECT_TRUE(compare(stage, s).contains("specular light")) << r.id;
  }
}

// The stencil that volumes mark lies beside the depth, and depth's digits are whole.
TEST_F(StoredBits, AStencilIsReadBesideTheDepth) {
  Stage stage(yard());
  Settings s = settings_for(yard(), kSize);
  s.background.skip = BackgroundSkip::stencil;
  for (const DepthFormat depth : {DepthFormat::d24, DepthFormat::d32f}) {
    s.depth.format = depth;
    stage.draw(s);
    std::set<uint32_t> marks;
    for (const glm::ivec2 pixel : {glm::ivec2(32, 30), glm::ivec2(0, 0)}) {
      const PixelProbe p = probe(stage, s, pixel);
      for (const StoredTexel& t : p.stored) {
        if (t.attachment.stores != Stores::light_depth) continue;
        EXPECT_TRUE(row(t.attachment.format).stencil);
        for (const FieldRead& r : read_fields(s, t))
          if (r.field.name == "stencil") marks.insert(r.codes.at(0));
      }
    }
    EXPECT_EQ(marks.size(), 2u) << "a surface is marked, the background is not";
  }
}

}  // namespace
}  // namespace gbl::test
