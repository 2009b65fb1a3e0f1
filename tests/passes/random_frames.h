#pragma once
// Frames of random valid settings over all axes, scenes, sizes and cameras, each judged: no error of GL, no number that
// is none, the plain loop's picture, and the reference's. One seed is one frame.
#include <fmt/format.h>

#include "renderer/gl/gl_error.h"
#include "renderer/opening/scene_look.h"
#include "renderer/options/settings_json.h"
#include "renderer/passes/judging.h"
#include "renderer/scenes/builtin_scenes.h"
#include "renderer/truth/measure.h"
#include "tests/passes/all_pairs.h"
#include "tests/random_view.h"

namespace gbl::test {

// Scenes that come with the lab, uploaded once each.
inline const GpuScene& builtin(size_t i) {
  static std::map<size_t, GpuScene> scenes;
  const auto found = scenes.find(i);
  if (found != scenes.end()) return found->second;
  const std::string name = std::string("builtin:") + builtin_scenes()[i].id;
  return scenes.try_emplace(i, open_scene(name)).first->second;
}

struct Framed {
  const GpuScene& scene;
  Settings settings;
  View view;  // looked at, beside `final`; a frame alone can show it
};

class RandomFrame {
 public:
  explicit RandomFrame(uint64_t seed)
      : random_(seed),
        index_(random_.next() % builtin_scenes().size()),
        name_(std::string("builtin:") + builtin_scenes()[index_].id),
        scene_(builtin(index_)),
        settings_(choose()),
        view_(frame_views()[random_.next() % frame_views().size()]) {}

  Framed frame() const { return {scene_, settings_, view_}; }

 private:
  template <class T, size_t N>
  T one_of(const T (&list)[N]) {
    return list[random_.next() % N];
  }
  bool chance(double p) { return random_.unit() < p; }

  Settings choose() {
    const DeviceLimits limits = limits_here();
    for (;;) {
      Settings s;
      apply_scene(s, name_, scene_.scene());
      choose_values(s);
      choose_numbers(s);
      s.size = one_of({glm::ivec2{1, 1}, {2, 1}, {1, 64}, {17, 409}, {64, 36}, {96, 54}, {33, 31}, {128, 5}});
      choose_camera(s);
      s.lights.source = chance(0.2) ? LightSource::scene : LightSource::generated;
      if (validate(s, limits).empty()) return s;
    }
  }

  // Half of the axes as they are: where everything is strange nothing is seen.
  void choose_values(Settings& s) {
    for (const Axis& axis : all_axes())
      if (chance(0.5)) {
        const Choice& c = axis[random_.next() % axis.size()];
        c.option->set(s, c.value->id, *c.option);
      }
    for (const MistakeRow& m : mistakes())
      if (chance(0.03)) s.mistakes.insert(m.mistake);
  }

  // Numbers of the table, from end to end of their ranges; what makes frames long is kept short.
  void choose_numbers(Settings& s) {
    for (const Option& o : options()) {
      if (o.group == Group::view || !chance(0.3)) continue;
      const std::string_view path = o.path;
      if (path.starts_with("camera.") || path == "time") continue;
      const double most = std::min(o.max, 1e4), least = std::max(o.min, -1e4);
      const double value = chance(0.2)   ? least
                           : chance(0.1) ? most
                                         : least + (most - least) * std::pow(random_.unit(), 4);
      if (o.kind == Kind::number) o.set(s, value, o);
    }
    s.lights.count = one_of({0, 1, 2, 16, 64, 150});
    s.lights.seed = random_.next();
    s.lights.range_scale = one_of({0.1, 1.0, 1.0, 3.0, 100.0});
    s.exposure = one_of({0.01, 1.0, 1.0, 1.0, 30.0});
    s.shadow.max_lights = one_of({0, 1, 3});
    s.tessellation.level = one_of({1, 4});
    s.time_s = one_of({0.0, 1.5, 1e4});
  }

  void choose_camera(Settings& s) {
    const Bounds& b = scene_.scene().bounds;
    const glm::dvec3 middle = b.centre(), reach = b.extent();
    const std::vector<Light> lights = resolve_frame(s, scene_.scene(), gl::device().features).lights;
    Camera& c = s.camera;
    switch (random_.next() % 8) {
      case 0: break;  // the scene's
      case 1:         // inside a light, looking anywhere
        if (!lights.empty()) c.position = lights[random_.next() % lights.size()].position;
        look_anywhere(c);
        break;
      case 2: c.orientation = c.orientation * orientation_from_yaw_pitch(180, 0); break;  // the scene lies behind
      case 3:                                                                             // far away, looking back
        c.position = middle + random_direction(random_) * 1e6;
        c.orientation = glm::quatLookAt(glm::normalize(middle - c.position), glm::dvec3(0, 1, 0));
        c.far = 3e6, c.near = 1;
        break;
      default:
        c.position = middle + reach * glm::dvec3(random_.in(-0.6, 0.6), random_.in(0, 0.6), random_.in(-0.6, 0.6));
        look_anywhere(c);
    }
    if (chance(0.3)) c.fov = one_of({3.0, 20.0, 120.0, 175.0});
    if (chance(0.15)) c.orthographic_height = one_of({0.5, 20.0, 500.0});
    if (chance(0.2)) c.near *= one_of({0.01, 10.0});
    if (chance(0.2)) c.far *= one_of({0.1, 1000.0});
  }
  void look_anywhere(Camera& c) {
    c.orientation = orientation_from_yaw_pitch(random_.in(-180, 180), random_.in(-90, 90));
  }

  Pcg32 random_;
  size_t index_;
  std::string name_;
  const GpuScene& scene_;
  Settings settings_;
  View view_;
};

// The largest finite number of a picture.
inline double peak(const Picture& p) {
  double most = 0;
  for (const glm::vec4& t : p.texels)
    for (int k = 0; k < 3; ++k)
      if (std::isfinite(t[k])) most = std::max(most, std::abs(double(t[k])));
  return most;
}

// What was found of one frame.
struct Verdict {
  std::string wrong;            // empty: nothing
  bool compared = false;        // with the plain loop
  size_t judged = 0, over = 0;  // pixels, by the reference
};

class FrameJudge {
 public:
  Verdict judge(const Framed& f) {
    Verdict v;
    try {
      draw_as_chosen(f, v);
      compare(f, v);
      ask_reference(f, v);
    } catch (const Error& e) {
      v.wrong += e.what();
    }
    if (const GLenum e = glGetError()) v.wrong += gl::error_text(e);
    return v;
  }

 private:
  Picture lit(const Settings& s, const GpuScene& scene) {
    renderer_.render(s, scene, targets_);
    return picture_of(*targets_.frame.texture(Stores::lit));
  }

  // Mistakes and unsound choices included: whatever it shows, nothing may break. Views, too.
  void draw_as_chosen(const Framed& f, Verdict& v) {
    const Settings& s = f.settings;
    FrameReport report = renderer_.render(s, f.scene, targets_);
    for (const View view : {View::final, f.view})
      if (why_missing(view, s).empty()) renderer_.draw_view(view, s, f.scene, targets_, {.overlays = true});
    renderer_.count_pairs(s, f.scene, targets_, true);
    renderer_.collect(targets_, report, true);
    if (report.pairs && report.pairs->lit && sound(s) && report.pairs->shaded < *report.pairs->lit)
      v.wrong += fmt::format("{} pairs shaded of {} that are lit; ", report.pairs->shaded, *report.pairs->lit);
  }

  void compare(const Framed& f, Verdict& v) {
    const Settings s = comparable(cured(f.settings));
    if (!validate(s, limits_here()).empty()) return;
    const Picture got = lit(s, f.scene), plain = lit(plain_twin(s), f.scene);
    Tolerance t = same_picture(s);
    t.max_abs *= std::max(1.0, peak(plain));
    const Difference d = difference(got, plain, t.max_abs);
    if (double(d.failing) > t.failing_fraction * double(got.count()))
      v.wrong += fmt::format("{} of {} pixels are off the plain loop's by more than {}, the worst by {} at {}; ",
                             d.failing, got.count(), t.max_abs, d.max_abs, d.worst);
    if (nonfinite(got) > 0) v.wrong += fmt::format("{} numbers are none; ", nonfinite(got));
    v.compared = true;
  }

  // All in floats, and nothing that only a map knows: what is left is the arithmetic.
  void ask_reference(const Framed& f, Verdict& v) {
    if (glm::length(f.settings.camera.position) > 1e5) return;  // there a float's position is off by 0.01 and more
    Settings s = lit_alone(cured(f.settings));
    s.tessellation.mode = TessellationMode::off;
    s.layout = Layout::float32, s.layout_file.clear();
    s.normal = {NormalEncoding::xyz32f, NormalSpace::world}, s.position.source = PositionSource::view32f;
    s.lights.method = LightMethod::fullscreen, s.lights.markers = LightMarkers::off;
    s.accumulation = {AccumulationFormat::rgba32f, AccumulationTargets::split};
    s.depth.format = DepthFormat::auto_, s.antialias = Antialias::none, s.background.skip = BackgroundSkip::depth;
    s.tangents = Tangents::vertex;
    if (!validate(s, limits_here()).empty()) return;
    TruthMaker maker(s, 2);
    const std::shared_ptr<const TruthSet> truth = maker.step(renderer_, f.scene, true);
    renderer_.render(s, f.scene, targets_);
    // Without the witness, which would be wrong in the same way where all shaders are.
    const BoundCheck b = check_bound(truth->truth, read_lit(targets_), {}, {s.exposure, s.colour}, 1 / 255.0);
    v.judged = b.compared, v.over = b.over;
    // At silhouettes, terminators and highlights floats may be off: as large a share as in the tests of the reference.
    if (double(b.over) > 2 + 0.005 * double(b.compared))
      v.wrong +=
          fmt::format("{} of {} pixels are off the reference by more than a code, the worst by {:.3g} codes at {},{}; ",
                      b.over, b.compared, 255 * b.worst, b.worst_pixel.x, b.worst_pixel.y);
  }

  Renderer renderer_;
  Targets targets_;
};

struct Tally {
  size_t frames = 0, compared = 0, judged = 0, over = 0;
};

// Frames of these seeds; each that is wrong is a failure that names its seed and its settings.
inline Tally expect_sound_frames(uint64_t first, int count) {
  FrameJudge judge;
  Tally tally;
  for (uint64_t seed = first; seed < first + static_cast<uint64_t>(count); ++seed) {
    const Framed frame = RandomFrame(seed).frame();
    const Verdict v = judge.judge(frame);
    EXPECT_EQ(v.wrong, "") << "seed " << seed << ": " << settings_text(frame.settings);
    tally.frames += 1, tally.compared += v.compared, tally.judged += v.judged, tally.over += v.over;
  }
  return tally;
}

}  // namespace gbl::test
