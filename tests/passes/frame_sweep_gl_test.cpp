// Frames over many settings: every view of every preset, random switches without a leak, nothing but numbers in `lit`,
// and the same picture far from the origin.
#include <set>

#include "renderer/base/random.h"
#include "renderer/gbuffer/normal_encoding.h"
#include "renderer/options/options.h"
#include "renderer/options/settings_json.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class FrameSweep : public GlTest {};

size_t colours_of(const Image& image) {
  std::set<std::array<uint8_t, 3>> colours;
  for (size_t i = 0; i < image.rgba.size(); i += 4)
    colours.insert({image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
  return colours.size();
}

TEST_F(FrameSweep, EveryViewOfEveryPresetShowsSomethingOrSaysWhyNot) {
  Stage stage(terrain());
  for (const Preset& p : presets()) {
    Settings s = p.make();
    if (s.scene != "builtin:terrain") continue;
    s.size = {160, 90};
    stage.draw(s);
    for (const View each : frame_views()) {
      const ViewRow& v = row(each);
      SCOPED_TRACE(fmt::format("{}: {}", p.id, v.id));
      const std::string missing = why_missing(v.view, s);
      if (!missing.empty()) {
        EXPECT_GT(missing.size(), 10u) << "a sentence is wanted";
        continue;
      }
      // At the least several counts of lights; all else has gradients.
      // What marks may find nothing to mark, in a scene without metals, maps or many objects as well.
      const bool may_be_one =
          (v.marks && v.view != View::lights_per_pixel) || (v.view >= View::reflectance && v.view <= View::object_id);
      const size_t enough = may_be_one ? 1 : v.view == View::lights_per_pixel ? 3 : 20;
      const Image plain = stage.view(v.view, s), wired = stage.view(v.view, s, {.overlays = true});
      EXPECT_GE(colours_of(plain), enough);
      // Window depth in 8 bits is all but white at these distances: that is what there is to see of it.
      const bool raw_depth = v.view == View::depth || v.view == View::position;
      EXPECT_GE(colours_of(stage.view(v.view, s, {.raw = true})), raw_depth || may_be_one ? 1u : 3u);
      EXPECT_EQ(wired == plain, s.view.volumes == VolumeOverlay::off);
    }
  }
}

// A random value for every choice that is drawn by the renderer, small sizes, few lights.
Settings random_settings(Pcg32& random) {
  Settings s = settings_for(yard());
  for (const Option& o : options()) {
    if (o.kind != Kind::choice || o.group == Group::view) continue;
    const ValueRow& r = o.values[random.next() % o.values.size()];
    const bool built = o.path != std::string_view("lights.source") || r.id == std::string_view("generated");
    if (built && gl::device().features.has(r.needs)) o.set(s, r.id, o);
  }
  s.lights.count = std::array{0, 1, 16, 40}[random.next() % 4];
  s.view.volumes = VolumeOverlay::all;
  return s;
}

glm::ivec2 random_size(Pcg32& random) {
  constexpr glm::ivec2 kSizes[] = {{1, 1}, {3, 2}, {2, 31}, {64, 36}, {17, 16}, {33, 65}};
  return kSizes[random.next() % std::size(kSizes)];
}

// Names that are alive only while a frame of these settings is: everything else must have been made once.
int names_beside_attachments(const Stage& stage) {
  return gl::live_names() - static_cast<int>(stage.targets.frame.attachments().size());
}

TEST_F(FrameSweep, AThousandSwitchesLeaveNothingBehind) {
  Pcg32 random(42);
  std::vector<Settings> pool;
  while (pool.size() < 8) pool.push_back(random_settings(random));
  Stage stage(yard());
  const auto look_at_everything = [&](const Settings& s) {
    stage.draw(s);
    for (const View v : frame_views())
      if (why_missing(v, s).empty()) stage.renderer.draw_view(v, s, yard(), stage.targets, {.overlays = true});
    stage.renderer.count_pairs(s, yard(), stage.targets, true);
    stage.renderer.start_probe(s, yard(), stage.targets, {0, 0});
  };
  Settings last = pool.front();
  last.size = {5, 5};
  // All variants, and the queries of all frames under way: what `auto` chooses goes with the size, what a light sees with
  // the time.
  const auto elsewhere = [&](Settings s) {
    s.size = random_size(random), s.time_s = random.in(0, 36);
    return s;
  };
  for (const Settings& s : pool)
    for (int k = 0; k < 40; ++k) stage.draw(elsewhere(s));
  for (int k = 0; k < 32; ++k) look_at_everything(elsewhere(pool[k / 16]));
  look_at_everything(last);
  const int names = names_beside_attachments(stage);
  for (int k = 0; k < 1000; ++k) {
    const bool look = k % 50 == 0;
    const Settings s = elsewhere(pool[random.next() % (look ? 2 : pool.size())]);
    if (look)
      look_at_everything(s);
    else
      stage.draw(s);
    ASSERT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << settings_text(s);
    // Some settings have more than `last`: samples, copies of depth, shadow maps. What leaks grows, and is found at the end.
    ASSERT_LE(names_beside_attachments(stage), names + 30) << k << ": " << settings_text(s);
  }
  look_at_everything(last);
  EXPECT_EQ(names_beside_attachments(stage), names);
}

TEST_F(FrameSweep, NoNamesOutliveARenderer) {
  const GpuScene& scene = yard();
  Stage(scene).draw(settings_for(scene, {4, 4}));  // textures of the scene are made at first use, and stay
  const int before = gl::live_names();
  {
    Stage stage(scene);
    Settings s = settings_for(scene, {4, 4});
    s.view.volumes = VolumeOverlay::all;
    stage.pairs(s);
    stage.view(View::final, s, {.overlays = true});
    EXPECT_GT(gl::live_names(), before);
  }
  EXPECT_EQ(gl::live_names(), before);
}

// Every value of every method axis on its own, on a scene with all directions (the pole of `stereo16f` included).
TEST_F(FrameSweep, LitHoldsNothingButNumbers) {
  Stage stage(yard());
  for (const Option& o : options()) {
    if (o.group != Group::method || o.kind != Kind::choice) continue;
    for (const ValueRow& r : o.values) {
      if (!gl::device().features.has(r.needs)) continue;
      Settings s = settings_for(yard(), {48, 27});
      o.set(s, r.id, o);
      EXPECT_EQ(nonfinite(stage.lit(s)), 0u) << o.path << "=" << r.id;
      s.lights.count = 1;
      EXPECT_EQ(nonfinite(stage.lit(s)), 0u) << o.path << "=" << r.id;
    }
  }
  Stage presets_stage(terrain());
  for (const Preset& p : presets()) {
    Settings s = p.make();
    s.size = {64, 36};
    if (s.scene != "builtin:terrain") continue;
    EXPECT_EQ(nonfinite(presets_stage.lit(s)), 0u) << p.id;
  }
}

// The texel that stands for a missing map is (128, 128, 255), a third of a degree off: it must not be used.
TEST_F(FrameSweep, WithoutANormalMapNormalsAreTheMeshesOwn) {
  Stage stage(yard());
  Settings s = settings_for(yard());
  ASSERT_EQ(s.normal_map, NormalMap::on);
  const Picture on = stage.lit(s);
  s.normal_map = NormalMap::off;
  EXPECT_TRUE(same_bits(stage.lit(s), on));
}

// Share of pixels whose shown normals differ by more than `codes` of 255 in a channel.
double normals_off(const Image& a, const Image& b, int codes) {
  size_t off = 0;
  for (size_t i = 0; i < a.rgba.size(); i += 4)
    for (int k = 0; k < 3; ++k)
      if (std::abs(a.rgba[i + k] - b.rgba[i + k]) > codes) {
        ++off;
        break;
      }
  return static_cast<double>(off) / (static_cast<double>(a.rgba.size()) / 4);
}

// Whatever normals are stored in and along, what is read back is along the world's axes and within the row's error.
TEST_F(FrameSweep, EverySoundEncodingShowsTheSameNormalsInBothSpaces) {
  Stage stage(yard());
  Settings s = settings_for(yard());
  s.lights.count = 1;
  s.normal.encoding = NormalEncoding::xyz32f;
  stage.draw(s);
  const Image exact = stage.view(View::normal, s);
  for_each_row<NormalSpace>([&](NormalSpace space, auto& where) {
    for_each_row<NormalEncoding>([&](NormalEncoding e, auto& r) {
      if (!r.sound()) return;
      SCOPED_TRACE(fmt::format("{}, {}", r.id, where.id));
      s.normal = {e, space};
      stage.draw(s);
      const double max_deg = row_of(e).toward_zero.value_or(row_of(e).error).max;
      const int codes = 1 + static_cast<int>(std::ceil(127.5 * glm::radians(max_deg)));
      EXPECT_EQ(normals_off(stage.view(View::normal, s), exact, codes), 0);
    });
  });
}

// `xy-only-z-sqrt`: what faces -Z is mirrored; along the camera's axes hardly anything seen does.
TEST_F(FrameSweep, WithoutTheSignOfZViewSpaceIsAllButRightAndWorldSpaceIsNot) {
  Stage stage(yard());
  Settings s = settings_for(yard());
  s.camera.position = {11, 4, 26};  // before a wall whose face looks towards -Z
  s.camera.orientation = orientation_from_yaw_pitch(180, -20);
  stage.draw(s);
  const Image exact = stage.view(View::normal, s);
  const auto off = [&](NormalSpace space) {
    s.normal = {NormalEncoding::xy_sqrt, space};
    stage.draw(s);
    return normals_off(stage.view(View::normal, s), exact, 5);  // 1.5 degrees at the rim are 4 codes
  };
  EXPECT_GT(off(NormalSpace::world), 0.1);
  EXPECT_LT(off(NormalSpace::view), 0.01);
}

// `stereographic-pole`: a wall that faces exactly -Z has no code. Its light is lost; nothing else is.
TEST_F(FrameSweep, OnlyTheStereographicPoleLosesItsLight) {
  Stage stage(yard());
  Settings s = light_alone(settings_for(yard(), {64, 36}));
  s.lights.range_scale = 2;
  s.camera.position = {11, 4, 26};  // before the wall whose face looks towards -Z
  s.camera.orientation = orientation_from_yaw_pitch(180, -20);
  const Picture good = stage.lit(s);
  const Image normals = stage.view(View::normal, s);
  s.normal.encoding = NormalEncoding::stereo16f;
  const Picture bad = stage.lit(s);
  int pole = 0;
  for (int y = 0; y < s.size.y; ++y)
    for (int x = 0; x < s.size.x; ++x) {
      const size_t i = size_t(y) * s.size.x + x;
      const uint8_t* n = &normals.rgba[4 * (size_t(s.size.y - 1 - y) * s.size.x + x)];
      const bool faces_pole = good.texels[i].a == 1 && n[2] == 0;
      if (faces_pole && good.texels[i].r > 0.01f) {
        ++pole;
        EXPECT_EQ(glm::vec3(bad.texels[i]), glm::vec3(0));
      } else if (!faces_pole) {
        // At most .028 degrees (the catalogue), times the slope of a highlight with the exponent of these surfaces.
        EXPECT_LT(glm::length(bad.texels[i] - good.texels[i]), 0.02f) << x << ", " << y;
      }
    }
  EXPECT_GT(pole, 100);
}

// Far from the origin nothing swims: the GPU is given only what is relative to the camera.
TEST_F(FrameSweep, TenMillionUnitsFromTheOriginThePictureIsTheSame) {
  Stage here(yard());
  const Settings s = settings_for(yard());
  const Picture expected = here.lit(s);
  const double origin = 1e7;
  const GpuScene moved(std::make_shared<const Scene>(make_yard(origin)));
  Stage there(moved);
  Settings far = s;
  far.camera.position.y += origin;
  // double holds 1e7 to 2e-9: a few edges of triangles fall on the other side of a pixel's centre, no more.
  EXPECT_TRUE(like(there.lit(far), expected, {.max_abs = 1e-4, .failing_fraction = 1e-3, .why = "edge pixels"}));
  far.position.reconstruct = PositionReconstruct::inverse_viewproj;  // float world positions: the pitfall
  EXPECT_TRUE(unlike(there.lit(far), expected, {.max_abs = 1e-2, .failing_fraction = 1e-2}));
}

}  // namespace
}  // namespace gbl::test
