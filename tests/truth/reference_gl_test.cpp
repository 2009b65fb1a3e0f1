// The reference against the GPU: the float32 forward frame agrees with it but for float's own noise, and the counts of
// the GPU are the reference's.
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include "app/truth_keeper.h"
#include "renderer/opening/scene_look.h"
#include "renderer/options/options.h"
#include "renderer/truth/measure.h"
#include "tests/gl_fixture.h"
#include "tests/truth/closed_scene.h"

namespace gbl::test {
namespace {

class ReferenceGl : public GlTest {
 protected:
  std::shared_ptr<const TruthSet> truth_of(const Settings& s, const GpuScene& scene) {
    TruthKeeper keeper(1, 2);
    return keeper.get(renderer, scene, s, true);
  }
  Renderer renderer;
  Targets targets;
};

double largest(const glm::dvec3& d) { return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}); }

Settings settings_of_scene(const char* name, const Scene& scene) {
  Settings s = preset("start").make();
  s.scene = name;
  apply_scene(s, name, scene);
  s.size = {160, 90};
  s.shadows = Shadows::off;  // a map is no witness of exact shadows
  s.view = {};
  return s;
}

// |witness - truth| relative to 1 + truth, sorted. Float32 shading against exact double was measured at 7e-6 for 64
// lights; what is beyond that stands at rims: a silhouette's barycentrics, a terminator, a highlight on a bent normal.
void expect_only_float_noise(const TruthSet& set, const std::string& what) {
  std::vector<double> off;
  for (size_t i = 0; i < set.truth.pixels(); ++i)
    off.push_back(largest(glm::dvec3(set.witness_lit[i]) - set.truth.lit[i]) / (1 + largest(set.truth.lit[i])));
  std::sort(off.begin(), off.end());
  const auto n = static_cast<double>(off.size());
  EXPECT_LE(off[static_cast<size_t>(0.5 * n)], 2e-7) << what;  // float's own rounding
  EXPECT_LE(off[static_cast<size_t>(0.99 * n)], 2e-5) << what;
  EXPECT_LE(off[static_cast<size_t>(0.995 * n)], 5e-4) << what;
}

TEST_F(ReferenceGl, TheWitnessAgreesInEveryScene) {
  for (const BuiltinScene& b : builtin_scenes()) {
    const std::string name = fmt::format("builtin:{}", b.id);
    const GpuScene scene(open_scene(name));
    for (const ShadingModel model : {ShadingModel::blinn_phong, ShadingModel::ggx}) {
      Settings s = settings_of_scene(name.c_str(), scene.scene());
      s.shading.model = model;
      expect_only_float_noise(*truth_of(s, scene), fmt::format("{} {}", name, row(model).id));
    }
  }
}

// Every row of every axis that decides what is true, one at a time.
TEST_F(ReferenceGl, TheWitnessAgreesForEveryTruth) {
  const GpuScene scene(open_scene("builtin:room"));
  const Settings base = settings_of_scene("builtin:room", scene.scene());
  for (const Option& o : options()) {
    if (o.group != Group::truth || o.kind != Kind::choice || std::string_view(o.path) == "lights.markers") continue;
    for (const ValueRow& r : o.values) {
      Settings s = base;
      o.set(s, r.id, o);
      if (s.lights.source == LightSource::rig) continue;  // reads a file
      if (!has_witness(s)) {
        EXPECT_TRUE(truth_of(s, scene)->witness_lit.empty()) << "no map, no mirror's picture and no step is exact";
        continue;
      }
      expect_only_float_noise(*truth_of(s, scene), fmt::format("{}={}", o.path, r.id));
    }
  }
  Settings level = base;
  level.camera.orthographic_height = 6;
  expect_only_float_noise(*truth_of(level, scene), "orthographic");
  // All rays of an orthographic camera see the sky in one direction.
  level.background.fill = BackgroundFill::sky;
  level.camera.position.y += 3;
  expect_only_float_noise(*truth_of(level, scene), "orthographic, sky");
}

// glTF turns a back face's mapped normal round: a frame from derivatives, in which the eye is always in front, must, too.
TEST_F(ReferenceGl, FramesFromDerivativesTurnWithBackFacesAndMirrors) {
  Scene wall;
  Mesh m{"wall", {}, {0, 1, 2, 2, 1, 3}};
  for (const float y : {-1.0f, 1.0f})
    for (const float x : {-1.5f, 1.5f})
      m.vertices.push_back({{x, y, 0}, {0, 0, 1}, {1, 0, 0, 1}, {x / 3 + 0.5f, 0.5f - y / 2}});
  wall.meshes = {m};
  wall.textures = {{.name = "tilted", .size = {1, 1}, .rgba = {191, 160, 230, 255}}};
  wall.materials = {{.normal_texture = {.texture = 0}, .double_sided = true}};
  wall.instances = {{"wall", 0, 0, glm::dmat4(1)}};
  wall.bounds = bounds_of(wall);
  Settings s = closed_settings();
  s.camera.position = {0.3, 0.2, 4};
  s.camera.orientation = orientation_from_yaw_pitch(3, -2);
  s.lights.source = LightSource::generated;
  s.layout = Layout::float32;
  s.normal.encoding = NormalEncoding::xyz32f;
  s.tangents = Tangents::derivatives;
  for (const glm::dvec3 scale : {glm::dvec3(1), glm::dvec3(-1, 1, 1), glm::dvec3(1, 1, -1), glm::dvec3(-1, -1, -1)})
    for (const double yaw : {0.0, 180.0}) {
      wall.instances[0].world_from_object = glm::scale(glm::mat4_cast(orientation_from_yaw_pitch(yaw, 0)), scale);
      const GpuScene scene(std::make_shared<const Scene>(wall));
      const auto set = truth_of(s, scene);
      renderer.render(s, scene, targets);
      const Errors e = measure(set->truth, read_drawn(renderer, s, scene, targets, false), {s.exposure, s.colour});
      EXPECT_LE(e.normal_deg_max.value(), 0.01) << yaw << " " << scale.x << scale.y << scale.z;
    }
}

// An image of 16 bits keeps them on the GPU: normals turn by less than a step of 8 bits does, and dark colours stay apart.
TEST_F(ReferenceGl, ImagesOfSixteenBitsKeepThem) {
  Scene wall = make_plane(20, {.base_colour_texture = {.texture = 0}, .normal_texture = {.texture = 1}});
  const auto texture = [](uint16_t r, uint16_t g, uint16_t b) {
    return Texture{.name = "deep", .size = {1, 1}, .rgba16 = {r, g, b, 65535}};
  };
  wall.textures = {texture(300, 300, 300), texture(32768 + 100, 32768, 65535)};
  wall.bounds = bounds_of(wall);
  Settings s = closed_settings();
  for (const Colour colour : {Colour::srgb, Colour::as_tutorial}) {
    s.colour = colour;
    const GpuScene scene(std::make_shared<const Scene>(wall));
    const auto set = truth_of(s, scene);
    const size_t middle = set->truth.pixels() / 2 + 16;
    ASSERT_TRUE(set->truth.present[middle]);
    const double code = 300 / 65535.0, expected = colour == Colour::srgb ? code / 12.92 : code;
    EXPECT_NEAR(set->truth.albedo[middle].x, expected, 0.5 / 65535) << "in 8 bits it would be code 1: 0.0039";
    EXPECT_NEAR(set->texels[middle].normal.x, (32768 + 100) / 65535.0, 1e-6);
  }
}

// KHR_materials_unlit: the display shows the colour as it is, whatever the lights and the exposure are.
TEST_F(ReferenceGl, UnlitSurfacesAreShownAsTheyAre) {
  Scene wall = make_plane(20, {.base_colour = {0.5f, 0.2f, 0.1f, 1}, .unlit = true});
  wall.lights = {point_light({0, 2, 0}, kEndless, glm::dvec3(1000))};
  wall.bounds = bounds_of(wall);
  const GpuScene scene(std::make_shared<const Scene>(wall));
  struct Way {
    Layout layout;
    LightMethod method;
    double
        tolerance;  // of the display's linear 0..1: half a step of the stored sRGB code, at most 2.3/255 / 2 near white
  };
  for (const Way way : {Way{Layout::float32, LightMethod::fullscreen, 1e-6},
                        {Layout::float32, LightMethod::forward, 1e-6},
                        {Layout::compact_metal, LightMethod::fullscreen, 0.0046},
                        {Layout::exact_emission, LightMethod::fullscreen, 0.0012}})
    for (const double exposure : {1e-3, 1.0, 400.0}) {
      Settings s = closed_settings();
      s.shading.model = ShadingModel::ggx;
      s.layout = way.layout, s.lights.method = way.method, s.exposure = exposure, s.ambient = 0.2;
      renderer.render(s, scene, targets);
      const std::vector<glm::vec3> lit = read_lit(targets);
      const auto set = truth_of(s, scene);
      const size_t middle = set->truth.pixels() / 2 + 16;
      for (int k = 0; k < 3; ++k) {
        const double base = double(wall.materials[0].base_colour[k]);
        EXPECT_NEAR(double(lit[middle][k]) * exposure, base, way.tolerance) << row(way.layout).id << " " << exposure;
        EXPECT_NEAR(set->truth.lit[middle][k] * exposure, base, 1e-12);
      }
    }
}

// KHR_materials_ior and KHR_materials_specular: the reflectance at normal incidence is min(((n - 1) / (n + 1))^2 colour, 1)
// weight where the surface is no metal. The view of F0 shows it, and the reference adds it to the light of the sky.
TEST_F(ReferenceGl, NonMetalsReflectWhatTheirIndexAndTheirMapsSay) {
  Scene wall = make_plane(20, {.base_colour = {0.2f, 0.3f, 0.4f, 1}, .roughness = 0.6f});
  wall.textures = {{.name = "weight and colour",
                    .size = {1, 1},
                    .rgba = {255, 255, 0, 128}}};  // ends of the sRGB curve: drivers agree there
  wall.bounds = bounds_of(wall);
  const double alpha = 128 / 255.0;
  struct Case {
    float index, weight, metal;
    glm::vec3 colour;
    bool maps;
    glm::dvec3 expected;
  };
  const double water = 0.33 * 0.33 / (2.33 * 2.33);
  const Case cases[] = {{1.5f, 1, 0, glm::vec3(1), false, glm::dvec3(0.04)},
                        {1.33f, 1, 0, glm::vec3(1), false, glm::dvec3(water)},
                        {1, 1, 0, glm::vec3(1), false, glm::dvec3(0)},
                        {0, 0.5f, 0, glm::vec3(1), false, glm::dvec3(0.5)},
                        {1.5f, 0.25f, 0, {1, 0.5f, 30}, false, {0.01, 0.005, 0.25}},
                        {1.5f, 0.5f, 0, {1, 2, 1}, true, {0.02 * alpha, 0.04 * alpha, 0}},
                        {1.5f, 0.5f, 0.5f, glm::vec3(1), false, {0.11, 0.16, 0.21}}};
  for (const Case& c : cases) {
    Material& m = wall.materials[0];
    m.refraction_index = c.index, m.specular = c.weight, m.metal = c.metal, m.specular_colour = c.colour;
    m.specular_texture.texture = m.specular_colour_texture.texture = c.maps ? 0 : kNoTexture;
    const GpuScene scene(std::make_shared<const Scene>(wall));
    Settings s = closed_settings();
    s.shading.model = ShadingModel::ggx;
    s.lights.method = LightMethod::fullscreen;
    s.ambient = 1;
    const auto set = truth_of(s, scene);
    const size_t middle = set->truth.pixels() / 2 + 16;
    const glm::dvec3 base(wall.materials[0].base_colour);
    const glm::dvec3 unlit = base * (1 - double(c.metal)) + c.expected;
    // Base colour and F0 of ten bits, sRGB-coded: half a step each, and the curve is nowhere steeper than 2.4.
    for (const auto& [layout, tolerance] : {std::pair{Layout::float32, 1e-6}, {Layout::exact_specular, 2.4 / 1023}}) {
      s.layout = layout;
      renderer.render(s, scene, targets);
      const std::vector<glm::vec3> lit = read_lit(targets);
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(set->truth.lit[middle][k], unlit[k], 1e-7) << c.index << " " << c.weight << " " << k;
        EXPECT_NEAR(double(lit[middle][k]), unlit[k], tolerance) << row(layout).id << " " << c.index << " " << k;
      }
    }
  }
}

// Both ends of every number that decides what is true.
TEST_F(ReferenceGl, TheWitnessAgreesAtTheEndsOfEveryNumber) {
  const GpuScene scene(open_scene("builtin:room"));
  Settings base = settings_of_scene("builtin:room", scene.scene());
  base.shading.model = ShadingModel::blinn_phong;  // has numbers of its own
  for (const Option& o : options()) {
    if (o.group != Group::truth || o.kind != Kind::number || std::string_view(o.path).starts_with("camera.")) continue;
    for (const double end : {o.min, o.max}) {
      Settings s = base;
      o.set(s, end, o);
      if (!in_use(o, s)) continue;
      expect_only_float_noise(*truth_of(s, scene), fmt::format("{}={}", o.path, end));
    }
  }
}

// A sunlit wall is brighter than half floats reach, and a dim lamp darker than they resolve: sums are kept in the
// display's units there.
TEST_F(ReferenceGl, AnyLightIsSummedInHalfFloats) {
  Scene wall = make_plane(20, {.base_colour = {0.9f, 0.9f, 0.9f, 1}, .roughness = 0.6f});
  wall.lights.resize(1);
  wall.lights[0].kind = LightKind::directional;
  wall.lights[0].direction = glm::normalize(glm::dvec3(0.3, -1, -0.2));
  wall.bounds = bounds_of(wall);
  for (const double lux : {1e5, 1.0, 1e-5})
    for (const AccumulationTargets targets_kind : {AccumulationTargets::split, AccumulationTargets::one}) {
      wall.lights[0].colour = glm::dvec3(lux);
      const GpuScene scene(std::make_shared<const Scene>(wall));
      Settings s = closed_settings();
      s.shading.model = ShadingModel::ggx;
      s.exposure = 0.6 / lux, s.ambient = 0.2 / s.exposure;
      s.lights.method = LightMethod::fullscreen;
      s.layout = Layout::float32;
      s.accumulation = {AccumulationFormat::rgba16f, targets_kind};
      const auto set = truth_of(s, scene);
      renderer.render(s, scene, targets);
      const Errors errors = measure(set->truth, read_drawn(renderer, s, scene, targets, false), {s.exposure, s.colour});
      EXPECT_EQ(errors.nonfinite_pixels.value(), 0) << lux;
      EXPECT_LE(errors.max_linear.value() * s.exposure, 1e-3) << lux << ": a half float's step below 1 is 1/2048";
    }
}

TEST_F(ReferenceGl, SeesTheTrianglesThatRaysMeet) {
  const Settings s = settings_for(yard());
  const auto set = truth_of(s, yard());
  const std::vector<SeenTexel> by_rays = seen_by_rays(yard().scene(), s);
  size_t other = 0;
  for (size_t i = 0; i < by_rays.size(); ++i) {
    const bool present = by_rays[i].instance() >= 0;
    if (present != bool(set->truth.present[i])) ++other;
  }
  EXPECT_LE(other, by_rays.size() / 1000) << "the rasteriser snaps corners to 1/256 of a pixel: rims may differ";
}

TEST_F(ReferenceGl, CountsTheLitPairsThatTheGpuCounts) {
  for (const GpuScene* scene : {&yard(), &terrain()}) {
    Settings s = settings_for(*scene);
    s.depth.format = DepthFormat::d32f_reversed;
    const auto set = truth_of(s, *scene);
    const uint64_t gpu = shared_stage(*scene).pairs(s).lit.value();
    // A point at the rim of a light falls on either side of it by float's rounding.
    EXPECT_NEAR(double(set->lit_pairs), double(gpu), 1e-4 * double(gpu) + 2);
    EXPECT_GT(gpu, 0u);
  }
}

TEST_F(ReferenceGl, ATruthIsKeptAndMadeAnewOnlyWhenTheTruthChanges) {
  TruthKeeper keeper(2, 1);
  Settings s = settings_for(yard(), {32, 18});
  const auto first = keeper.get(renderer, yard(), s, true);
  s.normal.encoding = NormalEncoding::oct8;
  s.lights.method = LightMethod::clustered;
  s.mistakes = {Mistake::tbn_precedence};
  EXPECT_EQ(keeper.get(renderer, yard(), s, true), first) << "how it is drawn is not part of what is true";
  s.ambient = 0.3;
  EXPECT_NE(keeper.get(renderer, yard(), s, true), first);
  EXPECT_FALSE(keeper.working());
  s.ambient = 0.4;
  s.size = {320, 180};
  while (!keeper.get(renderer, yard(), s, false)) EXPECT_LE(keeper.progress(), 1);
}

}  // namespace
}  // namespace gbl::test
