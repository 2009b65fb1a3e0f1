// A method chooses which pixel-light pairs are shaded: every sound choice gives the picture of the full-screen loop,
// every unsound row differs from it by the failure it names.
#include <set>

#include "renderer/lessons.h"
#include "renderer/options.h"
#include "renderer/random.h"
#include "renderer/settings_json.h"
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

// Every sound combination of the rows that say how pairs are chosen; new rows join by themselves.
template <class Each>
void for_each_sound_method(const Settings& base, Each each) {
  std::set<std::string> done;  // a method without volumes looks the same under all rows of a volume
  for_each_row<LightMethod>([&](LightMethod method, auto& m) {
    for_each_row<LightCull>([&](LightCull cull, auto& c) {
      for_each_row<VolumeLevel>([&](VolumeLevel level, auto& l) {
        for_each_row<VolumeFit>([&](VolumeFit fit, auto& f) {
          for_each_row<VolumeClip>([&](VolumeClip clip, auto& p) {
            for_each_row<VolumeDepth>([&](VolumeDepth depth, auto& d) {
              Settings s = base;
              s.lights.method = method, s.lights.cull = cull, s.lights.volume = {level, fit, clip, depth};
              const bool volumes = in_use(option("lights.cull"), s);
              const std::string name =
                  volumes ? fmt::format("{} {} {} {} {} {}", m.id, c.id, l.id, f.id, p.id, d.id) : m.id;
              if (sound(s) && done.insert(name).second) each(s, name);
            });
          });
        });
      });
    });
  });
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
  EXPECT_GE(combinations, 12);  // two loops, and volumes with two culls at five levels; more when rows are added
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
    expect_all_methods_agree(stage, s, fmt::format("pose {} ({})", k, to_json(s).dump()));
  }
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
    EXPECT_EQ(stage.draw(s).draw_calls, one) << row(method).id;
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
      EXPECT_NE(report.method, LightMethod::auto_);
      EXPECT_NE(report.method_reason, "");
      chosen.insert(report.method);
      s.lights.method = report.method;
      EXPECT_TRUE(same_bits(stage.lit(s), lit)) << row(report.method).id;
      EXPECT_EQ(stage.pairs(s).tested, pairs.tested) << row(report.method).id;
      EXPECT_TRUE(stage.view(View::lights_per_pixel, s) == view) << row(report.method).id;
      EXPECT_EQ(stage.draw(s).method_reason, "") << "asked for by name";
    }
  EXPECT_GE(chosen.size(), 3u);
}

// Lists that shrink and grow with the camera's motion are put into the texture that is there.
TEST_F(Methods, ClusterListsKeepTheirTexture) {
  Stage stage(yard());
  Settings s = settings_for(yard(), {64, 36});
  s.lights.method = LightMethod::clustered;
  s.lights.count = 300;
  stage.draw(s);
  const GLuint texture = stage.targets.light_lists.id();
  for (int k = 0; k < 20; ++k) {
    s.camera.position.x += 0.2;
    stage.draw(s);
    EXPECT_EQ(stage.targets.light_lists.id(), texture) << k;
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

}  // namespace
}  // namespace gbl::test
