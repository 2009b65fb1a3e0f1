// Every unsound row of the axes that store and rebuild surfaces, and every mistake by id, fails in the way it names; the
// mended settings do not.
#include <functional>

#include "renderer/options/options.h"
#include "renderer/options/settings_json.h"
#include "renderer/pitfalls/mistakes.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class SurfacePitfalls : public GlTest {};

Settings raw_normals(const GpuScene& scene) {
  Settings s = settings_for(scene);
  s.normal.encoding = NormalEncoding::xyz32f;
  return s;
}

Picture stored_normals(const Settings& s, const GpuScene& scene) {
  Stage& stage = shared_stage(scene);
  stage.draw(s);
  return picture_of(*stage.targets.texture(Stores::normal));
}

bool surface(const glm::vec4& n) { return glm::dot(glm::vec3(n), glm::vec3(n)) > 0; }

// Mean angle between two settings' stored normals, degrees.
double mean_angle(const Settings& a, const Settings& b, const GpuScene& scene) {
  const Picture x = stored_normals(a, scene), y = stored_normals(b, scene);
  double sum = 0;
  int n = 0;
  for (size_t i = 0; i < x.count(); ++i) {
    if (!surface(x.texels[i]) || !surface(y.texels[i])) continue;
    const glm::vec3 u = glm::normalize(glm::vec3(x.texels[i])), v = glm::normalize(glm::vec3(y.texels[i]));
    sum += glm::degrees(std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)));
    ++n;
  }
  return n > 0 ? sum / n : -1;
}

// Stored normals whose length is off by more than a hundredth.
int odd_lengths(const Settings& s, const GpuScene& scene) {
  int odd = 0;
  for (const glm::vec4& n : stored_normals(s, scene).texels)
    odd += surface(n) && std::abs(glm::length(glm::vec3(n)) - 1) > 0.01f;
  return odd;
}

// Pixels where `a` is brighter than `b` by more than 1/255 in some channel; negative: darker.
struct Compared {
  int brighter = 0, darker = 0;
};
Compared compared(const Settings& a, const Settings& b, const GpuScene& scene) {
  Stage& stage = shared_stage(scene);
  const auto shown = [&](const Settings& s) {
    stage.draw(s);
    return picture_of(stage.targets.shown());
  };
  const Picture x = shown(a), y = shown(b);
  Compared out;
  for (size_t i = 0; i < x.count(); ++i) {
    const glm::vec3 d(x.texels[i] - y.texels[i]);
    out.brighter += std::max({d.x, d.y, d.z}) > 1.0f / 255;
    out.darker += std::min({d.x, d.y, d.z}) < -1.0f / 255;
  }
  return out;
}

// A ball squashed to a quarter of its height.
const GpuScene& squashed() {
  static const GpuScene scene = [] {
    Scene s = make_yard();
    s.instances[3].world_from_object =
        s.instances[3].world_from_object * glm::dmat4(glm::dmat3(1, 0, 0, 0, 0.25, 0, 0, 0, 1));
    return GpuScene(std::make_shared<const Scene>(std::move(s)));
  }();
  return scene;
}

const GpuScene& grove() {
  static const GpuScene scene(std::make_shared<const Scene>(build_grove()));
  return scene;
}
const GpuScene& grid() {
  static const GpuScene scene(std::make_shared<const Scene>(build_grid()));
  return scene;
}

Settings grove_settings() {
  Settings s = preset("viewspace-fixed").make();
  s.size = {160, 90};
  s.layout = Layout::float32;
  s.background.skip = BackgroundSkip::depth;
  s.accumulation = {AccumulationFormat::rgba32f, AccumulationTargets::split};
  return s;
}

// Where the lighting takes the surface to be: the largest distance between the two settings' positions.
double largest_distance(const Settings& a, const Settings& b) {
  Stage& stage = shared_stage(terrain());
  const auto positions = [&](const Settings& s) {
    std::vector<glm::dvec3> out;
    stage.draw(s);
    for (int x = 44; x < s.size.x - 40; x += 8) {  // on the ground, some hundred to a few thousand units away
      stage.renderer.start_probe(s, terrain(), stage.targets, {x, s.size.y * 65 / 100});
      out.push_back((*stage.renderer.take_probe(stage.targets, true))[2]);
    }
    return out;
  };
  const std::vector<glm::dvec3> x = positions(a), y = positions(b);
  double largest = 0;
  for (size_t i = 0; i < x.size(); ++i) largest = std::max(largest, glm::distance(x[i], y[i]));
  return largest;
}

Settings with(Settings s, const char* mistake) {
  s.mistakes = {mistake};
  return s;
}

// The number that the failure is known by: of the broken settings, and of the mended ones.
struct Proof {
  double broken, mended;
  double at_least;  // the broken one's, by the catalogue
};

Proof background_shaded() {
  Settings s = settings_for(yard());
  Settings broken = s;
  broken.background.skip = BackgroundSkip::none;
  const auto lit_background = [](const Settings& drawn) {
    Stage& stage = shared_stage(yard());
    const Picture p = stage.lit(drawn);
    int n = 0;
    for (int y = p.size.y - 4; y < p.size.y; ++y)  // the top rows: sky
      for (int x = 0; x < p.size.x; ++x) n += p.texels[size_t(y) * p.size.x + x] != glm::vec4(0.2f, 0.2f, 0.2f, 0);
    return n;
  };
  return {double(lit_background(broken)), double(lit_background(s)), 600};
}

Proof tangents() {
  Settings s = grove_settings();
  s.normal = {NormalEncoding::xyz32f, NormalSpace::world};
  Settings broken = s;
  broken.tangents = Tangents::matrix_columns;
  Settings derived = s;
  derived.tangents = Tangents::derivatives;
  return {mean_angle(broken, s, grove()), mean_angle(derived, s, grove()), 1};
}

Proof resolved_samples() {
  Settings s = raw_normals(yard());
  Settings broken = s;
  broken.antialias = Antialias::msaa_resolved;
  return {double(odd_lengths(broken, yard())), double(odd_lengths(s, yard())), 50};
}

// One matrix for all pixels, or one that interpolation rounds anew at each: the same depth gives two positions.
Proof inverse_varying() {
  Settings uniform = settings_for(terrain(), {320, 180});
  uniform.camera = preset("nclgl").make().camera;
  uniform.position.reconstruct = PositionReconstruct::inverse_viewproj;
  Settings varying = uniform;
  varying.position.reconstruct = PositionReconstruct::inverse_viewproj_varying;
  return {largest_distance(varying, uniform), largest_distance(uniform, uniform), 0.01};
}

const std::map<std::string, std::function<Proof()>>& row_proofs() {
  static const std::map<std::string, std::function<Proof()>> proofs = {
      {"background.skip=none", background_shaded},
      {"tangents=matrix-columns", tangents},
      {"antialias=msaa-resolved", resolved_samples},
      {"position.reconstruct=inverse-viewproj-varying", inverse_varying},
  };
  return proofs;
}

const std::map<std::string, std::function<Proof()>>& mistake_proofs() {
  static const std::map<std::string, std::function<Proof()>> proofs = {
      {"tbn-precedence",
       [] {
         const Settings s = raw_normals(terrain());
         return Proof{mean_angle(with(s, "tbn-precedence"), s, terrain()), 0, 1};
       }},
      {"interpolated-not-normalised",
       [] {
         Settings s = raw_normals(terrain());
         s.normal_map = NormalMap::off;
         // Triangles of some degrees only: the deficit is small, but it is there; a unit normal is one to 1e-6.
         const auto shortest = [](const Settings& drawn) {
           float least = 1;
           for (const glm::vec4& n : stored_normals(drawn, terrain()).texels)
             if (surface(n)) least = std::min(least, glm::length(glm::vec3(n)));
           return 1 - double(least);
         };
         return Proof{shortest(with(s, "interpolated-not-normalised")), shortest(s), 1e-4};
       }},
      {"nonuniform-scale-normal",
       [] {
         const Settings s = raw_normals(squashed());
         return Proof{mean_angle(with(s, "nonuniform-scale-normal"), s, squashed()), 0, 0.3};
       }},
      {"blend-on-in-fill",
       [] {
         const Settings s = settings_for(yard());  // alpha is roughness there
         const Compared c = compared(with(s, "blend-on-in-fill"), s, yard());
         return Proof{double(c.darker), double(compared(s, s, yard()).darker), 1000};
       }},
      {"decode-not-normalised",
       [] {
         Settings s = settings_for(yard());
         s.normal.encoding = NormalEncoding::xyz8;
         s.shading = {ShadingModel::blinn_phong, 256, 1};
         const Compared c = compared(with(s, "decode-not-normalised"), s, yard());
         return Proof{double(c.brighter + c.darker), 0, 20};
       }},
      {"specular-ungated",
       [] {
         Settings s = settings_for(yard());
         s.shading = {ShadingModel::phong, 4, 0.5};
         const Compared c = compared(with(s, "specular-ungated"), s, yard());
         return Proof{double(c.brighter), double(c.darker), 50};  // it only ever adds light
       }},
      {"volume-without-distance-test",
       [] {
         Settings s = settings_for(yard());
         s.lights.count = 16;
         s.attenuation = Attenuation::none;
         const Compared c = compared(with(s, "volume-without-distance-test"), s, yard());
         return Proof{double(c.brighter), double(c.darker), 200};
       }},
      {"range-shortcut",
       [] {
         Settings s = settings_for(yard());
         s.attenuation = Attenuation::ramp;
         s.range.kind = RangeKind::threshold;
         const Compared c = compared(with(s, "range-shortcut"), s, yard());
         return Proof{double(c.darker), double(c.brighter), 200};
       }},
      {"forward-without-depth",
       [] {
         Settings s = preset("learnopengl-fixed").make();
         s.size = {160, 90};
         const Compared c = compared(with(s, "forward-without-depth"), s, grid());
         return Proof{double(c.brighter + c.darker), 0, 20};
       }},
  };
  return proofs;
}

void expect_proof(const std::string& name, const Proof& p) {
  EXPECT_GE(p.broken, p.at_least) << name;
  EXPECT_LT(p.mended, 0.2 * p.broken) << name << ": the mended settings must not fail, too";
}

TEST_F(SurfacePitfalls, EveryUnsoundRowHasAProof) {
  for (const Option& o : options()) {
    const std::string_view path = o.path;
    // Proved by tests of their own: which pairs are shaded, and the encodings of normals.
    if (o.group != Group::method || path.starts_with("lights.") || path == "normal.encoding") continue;
    for (const ValueRow& r : o.values) {
      if (r.sound()) continue;
      const std::string name = fmt::format("{}={}", o.path, r.id);
      ASSERT_TRUE(row_proofs().count(name)) << name << " is unsound and nothing shows its " << r.pitfall;
      expect_proof(name, row_proofs().at(name)());
    }
  }
}

TEST_F(SurfacePitfalls, EveryMistakeHasAProof) {
  for (const Mistake& m : mistakes()) {
    ASSERT_TRUE(mistake_proofs().count(m.id)) << m.id;
    expect_proof(m.id, mistake_proofs().at(m.id)());
  }
}

// The headline bug is invisible on flat ground: turning (1, 1, 1) gives (1, 1, 1) there.
TEST_F(SurfacePitfalls, TbnPrecedenceIsHiddenByGroundWithoutANormalMap) {
  const Settings s = raw_normals(yard());
  EXPECT_EQ(mean_angle(with(s, "tbn-precedence"), s, yard()), 0);
}

}  // namespace
}  // namespace gbl::test
