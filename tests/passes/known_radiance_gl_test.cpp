// Whole frames whose radiance is known in closed form, through every lighting method. The expected numbers come from the
// formulas written here: neither from the reference nor from another method, with which a mistake could be shared.
#include "renderer/frame/validate.h"
#include "renderer/options/options.h"
#include "tests/gl_fixture.h"
#include "tests/test_support.h"

namespace gbl::test {
namespace {

const glm::dvec3 kAlbedo(0.8, 0.5, 0.25);

// Everything stored and summed in float32.
Settings exact_settings(LightMethod method) {
  Settings s;
  s.size = {64, 36};
  s.lights.source = LightSource::scene;
  s.lights.method = method;
  s.shading.model = ShadingModel::lambert;
  s.background.fill = BackgroundFill::black;
  s.ambient = 0;
  s.layout = Layout::float32;
  s.normal.encoding = NormalEncoding::xyz32f;
  s.position.source = PositionSource::view32f;
  s.accumulation.format = AccumulationFormat::rgba32f;
  return s;
}

Scene scene_of(Mesh mesh) {
  Scene s;
  s.name = mesh.name;
  s.meshes = {std::move(mesh)};
  s.materials = {{.base_colour = glm::vec4(glm::vec3(kAlbedo), 1), .roughness = 1}};
  s.instances = {{"it", 0, 0, glm::dmat4(1)}};
  s.bounds = bounds_of(s);
  return s;
}

class KnownRadiance : public GlTest, public ::testing::WithParamInterface<LightMethod> {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    const ValueRow& r = row(GetParam());
    if (!gl::device().features.has(r.needs)) GTEST_SKIP() << r.id << " needs what this device lacks";
    EXPECT_TRUE(validate(exact_settings(GetParam()), {gl::device().features}).empty());
  }
};

std::string name_of(const ::testing::TestParamInfo<LightMethod>& info) {
  std::string name = row(info.param).id;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::vector<LightMethod> all_methods() {
  std::vector<LightMethod> out;
  for (const ValueRow& r : rows<LightMethod>())
    if (static_cast<LightMethod>(r.value) != LightMethod::auto_) out.push_back(static_cast<LightMethod>(r.value));
  return out;
}
INSTANTIATE_TEST_SUITE_P(Every, KnownRadiance, ::testing::ValuesIn(all_methods()), name_of);

// ---- furnaces: a convex body in light that is the same from everywhere -----------------------------------------

Settings before_the_ball(LightMethod method) {
  Settings s = exact_settings(method);
  s.camera.position = {0.5, 1, 5};
  s.camera.orientation = orientation_from_yaw_pitch(5, -11);
  s.camera.near = 0.1, s.camera.far = 100;
  return s;
}

// Calls check(texel) for every pixel of the body and demands black without any trace elsewhere.
template <class Check>
void each_of_the_body(const Picture& lit, Check check) {
  size_t seen = 0;
  for (const glm::vec4& texel : lit.texels)
    if (texel.a == 1)
      check(glm::dvec3(texel)), ++seen;
    else
      EXPECT_EQ(texel, glm::vec4(0));
  EXPECT_GT(seen, lit.count() / 10);
  EXPECT_LT(seen, lit.count());
}

TEST_P(KnownRadiance, InAmbientLightAloneABodyIsItsAlbedo) {
  const GpuScene scene(std::make_shared<const Scene>(scene_of(make_ellipsoid({1.5, 1, 1.5}, 24, 12))));
  Settings s = before_the_ball(GetParam());
  s.ambient = 1;
  each_of_the_body(Stage(scene).lit(s), [](const glm::dvec3& lit) {
    for (int k = 0; k < 3; ++k) EXPECT_FLOAT_EQ(float(lit[k]), float(kAlbedo[k]));
  });
}

// A Lambert surface facing n lights that stand evenly around it collects n/4 of one that it faces; 100 directions of
// equal areas leave 0.65 % of that to chance.
TEST_P(KnownRadiance, InLightFromAllSidesABodyIsItsAlbedo) {
  constexpr int kLights = 100;
  Scene body = scene_of(make_ellipsoid({1.5, 1, 1.5}, 24, 12));
  for (const glm::dvec3& direction : fibonacci_sphere(kLights))
    body.lights.push_back(
        {.colour = glm::dvec3(4.0 / kLights), .kind = LightKind::directional, .direction = direction});
  const GpuScene scene(std::make_shared<const Scene>(std::move(body)));
  double worst = 0;
  each_of_the_body(Stage(scene).lit(before_the_ball(GetParam())), [&](const glm::dvec3& lit) {
    for (int k = 0; k < 3; ++k) worst = std::max(worst, std::abs(lit[k] / kAlbedo[k] - 1));
  });
  EXPECT_LE(worst, 0.007);
}

// ---- one point light over a large plane --------------------------------------------------------------------------

constexpr double kFloat32 = 2e-6;  // twice the largest difference of float32 shading and storing
constexpr double kRange = 9;
const glm::dvec3 kLight(0.5, 2.5, -1), kColour(1, 0.5, 0.25);

// A level square at y = 0 that fills the picture.
Scene lit_plane() {
  Mesh m{"plane", {}, {0, 2, 1, 1, 2, 3}};
  for (const float z : {-60.0f, 60.0f})
    for (const float x : {-60.0f, 60.0f})
      m.vertices.push_back({.position = {x, 0, z}, .normal = {0, 1, 0}, .tangent = {1, 0, 0, 1}, .uv = {0, 0}});
  Scene s = scene_of(std::move(m));
  s.lights = {{.position = kLight, .colour = kColour, .range = kRange}};
  return s;
}

double windowed(double d) { return std::pow(std::max(0.0, 1 - std::pow(d / kRange, 4)), 2); }

// Every falloff up to the light's range, and one of them with every other end.
struct Falloff {
  Attenuation attenuation;
  double (*at)(double d);
  RangeKind end = RangeKind::source;
};
constexpr Falloff kFalloffs[] = {
    {Attenuation::none, [](double) { return 1.0; }},
    {Attenuation::linear, [](double d) { return 1 - d / kRange; }},
    {Attenuation::quadratic, [](double d) { return 1 / (1 + 0.7 * d + 1.8 * d * d); }},
    {Attenuation::ramp,
     [](double d) { return 1 / std::max(1.0, 0.2 + 1.6 * d / kRange + 6.4 * d * d / (kRange * kRange)); }},
    {Attenuation::inverse_linear, [](double d) { return kRange / (kRange + 9 * d); }},
    {Attenuation::windowed, [](double d) { return windowed(d) / (d * d); }},
    {Attenuation::gltf, [](double d) { return std::max(0.0, 1 - std::pow(d / kRange, 4)) / (d * d); }},
    {Attenuation::quadratic, [](double d) { return windowed(d) / (1 + 0.7 * d + 1.8 * d * d); }, RangeKind::windowed},
    {Attenuation::quadratic, [](double d) { return 1 / (1 + 0.7 * d + 1.8 * d * d); }, RangeKind::none},
};

// Where the ray through the middle of this pixel (rows from below) meets y = 0.
glm::dvec3 seen_point(const Settings& s, glm::ivec2 pixel) {
  const double half_height = std::tan(glm::radians(s.camera.fov / 2)), half_width = half_height * s.size.x / s.size.y;
  const glm::dvec3 in_view(((pixel.x + 0.5) * 2 / s.size.x - 1) * half_width,
                           ((pixel.y + 0.5) * 2 / s.size.y - 1) * half_height, -1);
  const glm::dvec3 direction = s.camera.orientation * in_view;
  return s.camera.position - direction * (s.camera.position.y / direction.y);
}

TEST_P(KnownRadiance, OneLightAboveAPlaneFallsOffAsTheFormulaSays) {
  const GpuScene scene(std::make_shared<const Scene>(lit_plane()));
  Stage stage(scene);
  Settings s = exact_settings(GetParam());
  s.camera.position = {1, 6, 7};
  s.camera.orientation = orientation_from_yaw_pitch(8, -40);
  s.camera.near = 0.1, s.camera.far = 1000;
  for (const Falloff& falloff : kFalloffs) {
    s.attenuation = falloff.attenuation, s.range.kind = falloff.end;
    const Picture lit = stage.lit(s);
    size_t wrong = 0;
    double worst = 0;
    for (int y = 0; y < s.size.y; ++y)
      for (int x = 0; x < s.size.x; ++x) {
        const double d = glm::distance(seen_point(s, {x, y}), kLight);
        if (std::abs(d - kRange) < 1e-4) continue;  // on either side of a sharp end, by rounding
        const double strength = d < kRange || falloff.end == RangeKind::none ? falloff.at(d) : 0;
        const glm::dvec3 expected = kAlbedo * kColour * (strength * kLight.y / d);  // y / d: the cosine
        const glm::dvec3 off = glm::abs(glm::dvec3(lit.texels[size_t(y) * s.size.x + x]) - expected);
        worst = std::max({worst, off.x, off.y, off.z});
        wrong += std::max({off.x, off.y, off.z}) > kFloat32;
      }
    EXPECT_EQ(wrong, 0u) << row(falloff.attenuation).id << " " << row(falloff.end).id << ": off by up to " << worst;
  }
}

TEST(KnownRadiances, EveryFalloffHasItsFormula) {
  std::set<Attenuation> known;
  for (const Falloff& f : kFalloffs) known.insert(f.attenuation);
  EXPECT_EQ(known.size(), rows<Attenuation>().size());
}

}  // namespace
}  // namespace gbl::test
