// A method chooses which pixel-light pairs are shaded: every sound choice gives the picture of the full-screen loop,
// every unsound row differs from it by the failure it names.
#include <functional>
#include <set>

#include "renderer/base/random.h"
#include "renderer/frame/validate.h"
#include "renderer/lessons/lessons.h"
#include "renderer/options/options.h"
#include "renderer/options/settings_json.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class Methods : public GlTest {};

struct NamedCamera {
  const char* name;
  Camera camera;
};

Camera camera_at(glm::dvec3 position, double yaw, double pitch, double near = 1, double far = 10000) {
  Camera c;
  c.position = position, c.orientation = orientation_from_yaw_pitch(yaw, pitch);
  c.near = near, c.far = far;
  return c;
}

Settings lesson_step(size_t k) {
  static const Lesson lesson = load_lesson("three-ways-to-lose-a-light");
  return settings_at(lesson, k);
}

std::vector<NamedCamera> terrain_cameras() {
  Camera flat = camera_at({2056, 2000, 2056}, 30, -60);
  flat.orthographic_height = 2500;
  return {{"start", preset("start").make().camera},
          {"nclgl", preset("nclgl-fixed").make().camera},
          {"inside many volumes", camera_at({2056, 120, 2056}, 40, -5)},
          {"from above", camera_at({2056, 7100, 2056}, 0, -90)},
          {"a volume between camera and near plane", lesson_step(2).camera},
          {"inside a mesh, outside its sphere", lesson_step(4).camera},
          {"lights beyond far", camera_at({2470, 340, 3320}, 7, -23, 1, 700)},
          {"orthographic", flat}};
}

// The options that say how pairs are chosen.
std::vector<const Option*> pair_options() {
  std::vector<const Option*> out;
  for (const Option& o : options()) {
    const std::string_view path = o.path;
    if (path == "lights.method" || path == "lights.cull" || path.starts_with("lights.volume.")) out.push_back(&o);
  }
  return out;
}

// Their values, but for those that the method has no use for: under these it looks the same.
std::string name_of(const Settings& s) {
  std::string name;
  for (const Option* o : pair_options())
    if (in_use(*o, s)) name += fmt::format("{}{}", name.empty() ? "" : " ", o->values[chosen(*o, s)].id);
  return name;
}

// Every combination that is sound and that this device draws; new rows join by themselves.
void for_each_sound_method(const Settings& base, const std::function<void(const Settings&, const std::string&)>& each) {
  std::set<std::string> done;
  const std::vector<const Option*> all = pair_options();
  const std::function<void(const Settings&, size_t)> choose = [&](const Settings& s, size_t i) {
    if (i == all.size()) {
      // Forward shading and deferred lighting store other bits: one_picture_gl_test compares them.
      const bool same_bits_stored = shading_of(s.lights.method) == Shading::deferred;
      const bool draws = same_bits_stored && sound(s) && validate(s, {gl::device().features}).empty();
      if (draws && done.insert(name_of(s)).second) each(s, name_of(s));
      return;
    }
    for (const ValueRow& r : all[i]->values) {
      Settings next = s;
      all[i]->set(next, r.id, *all[i]);
      choose(next, i + 1);
    }
  };
  choose(base, 0);
}

// Sums of at most 64 terms below 4, each rounded once: 64 * 4 * 2^-24 would be 1.5e-5. Only the lights in range
// add anything, and they are few.
constexpr Tolerance kSameSums{.max_abs = 2e-6,
                              .why = "equal terms, summed by the shader or by the blend: float rounding"};

void expect_all_methods_agree(Stage& stage, const Settings& base, const std::string& where) {
  Settings s = base;
  s.lights.method = LightMethod::fullscreen;
  const Picture reference = stage.lit(s);
  EXPECT_EQ(nonfinite(reference), 0u) << where;
  for_each_row<AccumulationTargets>([&](AccumulationTargets targets, auto& t) {
    s.accumulation.targets = targets;
    EXPECT_TRUE(like(stage.lit(s), reference, kSameSums)) << where << ": " << t.id << " against split";
    for_each_sound_method(s, [&](const Settings& other, const std::string& name) {
      EXPECT_TRUE(like(stage.lit(other), reference, kSameSums)) << fmt::format("{}: {}, {}", where, name, t.id);
    });
  });
}

TEST_F(Methods, SoundOnesAreCountedFromTheTables) {
  int combinations = 0;
  for_each_sound_method(settings_for(yard()), [&](auto&, auto&) { ++combinations; });
  // Two loops, volumes by two draws with two culls and one depth test, and by stencil, at five levels; more when rows
  // are added.
  EXPECT_GE(combinations, 2 + 2 * 3 * 5 + 5);
}

TEST_F(Methods, EverySoundOneGivesTheFullScreenPictureOfTheTerrain) {
  Stage stage(terrain());
  for (const NamedCamera& c : terrain_cameras()) {
    Settings s = settings_for(terrain(), {128, 72});
    s.camera = c.camera;
    expect_all_methods_agree(stage, s, c.name);
  }
}

// Random places, most of them inside some volume or a little outside one, looking anywhere; few or many lights.
TEST_F(Methods, EverySoundOneGivesTheFullScreenPictureOfTheYardFromAnywhere) {
  Stage stage(yard());
  Pcg32 random(7);
  for (int k = 0; k < 12; ++k) {
    Settings s = settings_for(yard(), {64, 36});
    s.camera = camera_at({random.in(2, 38), random.in(0.5, 12), random.in(2, 50)}, random.in(-180, 180),
                         random.in(-80, 30), random.in(0.05, 3), random.in(5, 100));
    s.lights.count = std::array{1, 2, 16, 64, 300}[k % 5];
    s.lights.seed = random.next();
    s.lights.range_scale = random.in(0.5, 2);
    s.time_s = random.in(0, 36);
    expect_all_methods_agree(stage, s, fmt::format("pose {} ({})", k, settings_text(s)));
  }
}

// The yard with lights of its own: spots from needles to floods, most drawn as cones; a few points; some with a falloff of their own; a
// spot and a sun without end.
Scene yard_of_spots(uint32_t seed) {
  Scene scene = make_yard();
  Pcg32 random(seed);
  for (int i = 0; i < 36; ++i) {
    Light l;
    l.kind = i % 6 == 5 ? LightKind::point : LightKind::spot;
    l.position = {random.in(0, 40), random.in(0.5, 10), random.in(0, 40)};
    l.colour = {random.in(0.2, 1), random.in(0.2, 1), random.in(0.2, 1)};
    l.range = random.in(3, 25);
    l.direction = glm::normalize(glm::dvec3(random.in(-1, 1), random.in(-1, 0.3), random.in(-1, 1)));
    const double outer = i % 4 ? random.in(5, 59) : i % 8 ? random.in(0.2, 5) : random.in(61, 89);
    l.outer_cos = std::cos(glm::radians(outer)), l.inner_cos = std::cos(glm::radians(outer * random.in(0, 1)));
    if (i % 9 == 4) l.coefficients = {1, random.in(0, 1), random.in(0, 0.5)};
    scene.lights.push_back(l);
  }
  scene.lights[0].range = kEndless;
  scene.lights[5].kind = LightKind::directional;
  scene.lights[5].colour *= 0.2;
  return scene;
}

TEST_F(Methods, EverySoundOneGivesTheFullScreenPictureOfSpotsFromAnywhere) {
  const GpuScene scene(std::make_shared<const Scene>(yard_of_spots(3)));
  Stage stage(scene);
  Pcg32 random(3);
  for (int k = 0; k < 8; ++k) {
    Settings s = settings_for(scene, {64, 36});
    s.lights.source = LightSource::scene;
    s.camera = camera_at({random.in(2, 38), random.in(0.5, 12), random.in(2, 50)}, random.in(-180, 180),
                         random.in(-80, 30), random.in(0.05, 1), random.in(20, 200));
    s.lights.range_scale = random.in(0.7, 1.5);
    if (k == 5) s.camera.orthographic_height = 30;
    if (k % 2) s.attenuation = Attenuation::none;  // a hard end: a mesh too small by a hair is seen
    expect_all_methods_agree(stage, s, fmt::format("pose {} ({})", k, settings_text(s)));
  }
}

// Where a mesh touches its sphere, a face and the surface differ in the last bits of depth, and light that ends hard
// shows who wins: without the margin of light_proxy.glsl some of these pictures lose a pixel or three.
TEST_F(Methods, TheLastBitsOfDepthLoseNoPixel) {
  Stage stage(terrain());
  Pcg32 random(1);
  for (int k = 0; k < 40; ++k) {
    Settings s = settings_for(terrain());
    s.attenuation = Attenuation::none;
    s.depth.format = k % 2 ? DepthFormat::d24 : DepthFormat::d32f;
    s.camera = camera_at({random.in(0, 4112), random.in(20, 700), random.in(0, 4112)}, random.in(-180, 180),
                         random.in(-80, 10));
    s.time_s = random.in(0, 36);
    s.lights.range_scale = random.in(0.3, 2);
    s.lights.volume.level = VolumeLevel::l4;
    s.lights.method = LightMethod::fullscreen;
    const Picture reference = stage.lit(s);
    s.lights.method = LightMethod::volumes_stencil;
    EXPECT_TRUE(like(stage.lit(s), reference, kSameSums)) << "pose " << k;
  }
}

PairCounts pairs_of_one(const Light& light) {
  Scene scene = make_yard();
  scene.lights = {light};
  const GpuScene uploaded(std::make_shared<const Scene>(std::move(scene)));
  Stage stage(uploaded);
  Settings s = settings_for(yard());
  s.lights.source = LightSource::scene;
  return stage.pairs(s);
}

TEST_F(Methods, AConeShadesLessThanItsSphere) {
  Light l;
  l.position = {20, 8, 32}, l.range = 12;
  const PairCounts sphere = pairs_of_one(l);
  l.kind = LightKind::spot;
  l.outer_cos = std::cos(glm::radians(25.0)), l.inner_cos = std::cos(glm::radians(20.0));
  const PairCounts cone = pairs_of_one(l);
  EXPECT_GT(*cone.lit, 0u);
  EXPECT_GE(cone.shaded, *cone.lit);
  EXPECT_LT(cone.shaded, sphere.shaded / 2);
}

// Other shapes of picture and other projections than the sweeps': tiles cut by the border, one pixel, a wide lens.
TEST_F(Methods, EverySoundOneGivesTheFullScreenPictureAtOddSizes) {
  Stage stage(yard());
  for (const glm::ivec2 size : {glm::ivec2(1, 1), {17, 33}, {131, 7}, {48, 48}})
    for (const double orthographic_height : {0.0, 30.0}) {
      Settings s = settings_for(yard(), size);
      s.camera.orthographic_height = orthographic_height;
      s.camera.fov = 100;
      s.lights.count = 300;
      expect_all_methods_agree(stage, s, fmt::format("{}x{} {}", size.x, size.y, orthographic_height));
    }
}

// Stores and blends round alike where a method blends once per pixel.
TEST_F(Methods, TiledStoresWhatTheFullScreenLoopStoresInEveryFormat) {
  if (!gl::device().features.has(Feature::compute)) GTEST_SKIP() << "tiled needs compute shaders";
  Stage stage(yard());
  for_each_row<AccumulationFormat>([&](AccumulationFormat format, auto& f) {
    for_each_row<AccumulationTargets>([&](AccumulationTargets targets, auto& t) {
      if (targets == AccumulationTargets::folded) return;  // the full-screen loop would store nothing
      Settings s = settings_for(yard(), {64, 36});
      s.accumulation = {format, targets};
      s.lights.method = LightMethod::fullscreen_radius;
      const Picture expected = stage.lit(s);
      s.lights.method = LightMethod::tiled;
      // A step of 8 bits, or of a mantissa of 5 bits below 4.
      const double step = format == AccumulationFormat::rgba8        ? 1.0 / 255
                          : format == AccumulationFormat::r11g11b10f ? 4.0 / 32
                                                                     : 1e-3;
      EXPECT_TRUE(like(stage.lit(s), expected, {.max_abs = 1.01 * step, .why = "one step of the format"}))
          << f.id << " " << t.id;
      EXPECT_TRUE(like(stage.lit(s), expected, {.max_abs = 1e-6, .failing_fraction = 0.05, .why = "rounding"}))
          << f.id << " " << t.id;
    });
  });
}

TEST_F(Methods, DrawCallsOfOneDrawAreAsManyForAnyNumberOfLights) {
  Stage stage(yard());
  for (const LightMethod method : {LightMethod::fullscreen, LightMethod::fullscreen_radius, LightMethod::quads,
                                   LightMethod::disc, LightMethod::tiled, LightMethod::clustered}) {
    if (!gl::device().features.has(row(method).needs)) continue;
    Settings s = settings_for(yard(), {16, 9});
    s.lights.method = method;
    s.lights.count = 1;
    const int one = stage.draw(s).draw_calls;
    s.lights.count = kMaxLights;
    const int looks = method == LightMethod::clustered ? 1 : 0;  // of many it is found out where surfaces are
    EXPECT_EQ(stage.draw(s).draw_calls, one + looks) << row(method).id;
    s.lights.count = 0;
    EXPECT_EQ(stage.draw(s).draw_calls, one - 1) << row(method).id;
  }
}

// The frame says what was chosen; light, counts and views are those of that method.
TEST_F(Methods, AutoDrawsTheMethodThatItNames) {
  Stage stage(yard());
  std::set<LightMethod> chosen;
  for (const double range_scale : {0.02, 1.0, 1000.0})
    for (const int count : {0, 3, 300}) {
      Settings s = settings_for(yard(), {64, 36});
      s.lights.count = count, s.lights.range_scale = range_scale;
      s.lights.method = LightMethod::auto_;
      const FrameReport report = stage.draw(s);
      const Picture lit = stage.lit(s);
      const PairCounts pairs = stage.pairs(s);
      const Image view = stage.view(View::lights_per_pixel, s);
      EXPECT_NE(report.drawn.lights.method, LightMethod::auto_);
      EXPECT_NE(report.method_reason, "");
      chosen.insert(report.drawn.lights.method);
      s.lights.method = report.drawn.lights.method;
      EXPECT_TRUE(same_bits(stage.lit(s), lit)) << row(report.drawn.lights.method).id;
      EXPECT_EQ(stage.pairs(s).tested, pairs.tested) << row(report.drawn.lights.method).id;
      EXPECT_TRUE(stage.view(View::lights_per_pixel, s) == view) << row(report.drawn.lights.method).id;
      EXPECT_EQ(stage.draw(s).method_reason, "") << "asked for by name";
    }
  EXPECT_GE(chosen.size(), 3u);
}

// Light that the light pass itself turns into the picture is what combine makes of float sums, sky and all.
TEST_F(Methods, FoldedLightIsThatOfFloatSums) {
  for (const GpuScene* scene : {&yard(), &terrain()})
    for (const Layout layout : {Layout::compact, Layout::float32, Layout::viewspace, Layout::stereo})
      for (const LightMethod method : {LightMethod::fullscreen, LightMethod::fullscreen_radius, LightMethod::clustered})
        for (const int lights : {0, 3, 40}) {
          Stage& stage = shared_stage(*scene);
          Settings s = settings_for(*scene, {64, 36});
          s.layout = layout, s.background.fill = BackgroundFill::sky;
          s.lights.method = method, s.lights.count = lights;
          s.accumulation = {AccumulationFormat::rgba32f, AccumulationTargets::split};
          const Picture summed = stage.lit(s);
          s.accumulation.targets = AccumulationTargets::folded;
          const FrameReport report = stage.draw(s);
          EXPECT_EQ(report.accumulation_bytes_per_pixel, 0);
          EXPECT_TRUE(like(stage.lit(s), summed, {.max_abs = 2e-6, .why = "the same sum, added up in another order"}))
              << gbl::row(layout).id << " " << gbl::row(method).id << " " << lights;
        }
}

// Rounded once, or cut off: llvmpipe does that.
TEST_F(Methods, FoldedLightIsStoredInTheFormatOfSums) {
  const struct {
    AccumulationFormat format;
    int mantissa;  // of the narrowest channel
  } kFormats[] = {{AccumulationFormat::rgba16f, 10}, {AccumulationFormat::r11g11b10f, 5}};
  Stage& stage = shared_stage(yard());
  Settings s = settings_for(yard(), {64, 36});
  s.lights.method = LightMethod::clustered, s.lights.count = 40;
  s.accumulation = {AccumulationFormat::rgba32f, AccumulationTargets::folded};
  const Picture exact = stage.lit(s);
  for (const auto& row : kFormats) {
    s.accumulation.format = row.format;
    const Picture rounded = stage.lit(s);
    const float step = std::ldexp(1.0f, -row.mantissa),
                least = std::ldexp(1.0f, -14);  // relative; the least normal number
    bool differs = false;
    for (size_t i = 0; i < exact.count(); ++i)
      for (int c = 0; c < 3; ++c) {
        const float a = exact.texels[i][c], b = rounded.texels[i][c];
        EXPECT_LE(std::abs(a - b), step * std::max(a, least)) << "pixel " << i << " channel " << c;
        differs |= a != b;
      }
    EXPECT_TRUE(differs) << gbl::row(row.format).id << " must round";
  }
}

// What a pair contributes depends on no method, so neither does it on the light's number or neighbours.
TEST_F(Methods, LightsAddUp) {
  Stage stage(yard());
  Settings s = light_alone(settings_for(yard(), {64, 36}));
  s.lights.count = 16;
  const Picture all = stage.lit(s);
  Picture sum = all;
  for (glm::vec4& t : sum.texels) t.x = t.y = t.z = 0;
  for (int i = 0; i < 16; ++i) {
    s.lights.only = i;
    const Picture one = stage.lit(s);
    for (size_t k = 0; k < sum.count(); ++k) sum.texels[k] += glm::vec4(glm::vec3(one.texels[k]), 0);
  }
  EXPECT_TRUE(like(sum, all, {.max_abs = 2e-6, .why = "16 float additions in another order of rounding"}));
}

// Loops take four lights at once; whatever is left over is filled up by dark ones.
TEST_F(Methods, NoNumberOfLightsLeavesOneOut) {
  Stage stage(yard());
  for (int count = 1; count <= 9; ++count) {
    Settings s = light_alone(settings_for(yard(), {64, 36}));
    s.lights.count = count;
    for (const Attenuation a : {Attenuation::none, Attenuation::gltf, Attenuation::ramp}) {
      s.attenuation = a;
      expect_all_methods_agree(stage, s, fmt::format("{} lights, {}", count, gbl::row(a).id));
    }
  }
}

}  // namespace
}  // namespace gbl::test
