// What keys and widgets do to the settings, each with its caption; what cannot be done becomes a notice.
#include <algorithm>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/frame/frame_lights.h"
#include "renderer/frame/validate.h"
#include "renderer/options/presets.h"
#include "renderer/options/settings_json.h"
#include "ui/camera_motion.h"
#include "ui/keys.h"
#include "ui/state.h"

namespace gbl::ui {
namespace {

// 0, 1, 2, 4, …, the maximum: from any number to its neighbour in that row.
int next_power(int n, int step, int max) {
  if (step > 0) {
    int p = 1;
    while (p <= n) p *= 2;
    return n == 0 ? std::min(1, max) : std::min(p, max);
  }
  if (n <= 1) return 0;
  int p = 1;
  while (p * 2 < n) p *= 2;
  return p;
}

// From lights that a scene or a rig brings, the number of generated ones goes on from theirs.
void go_on_from(FrameContext& f, const Option& o, Settings& s) {
  if (o.implies && s.lights.source != LightSource::generated)
    s.lights.count = static_cast<int>(all_lights_of(s, f.input.scene).size());
}

// What a number of generated lights takes the place of is said.
void say_step(FrameContext& f, const Option& o, const Settings& before) {
  Sentence sentence = describe_step(o, before, f.settings);
  if (before.lights.source != f.settings.lights.source && o.implies)
    sentence.text = fmt::format("{} generated lights instead of {}. “{}” brings those back.", f.settings.lights.count,
                                row(before.lights.source).label, option("lights.source").label);
  say(f, std::move(sentence));
}

// Shared by all ways to change settings: all or nothing, and an Error is shown, never thrown into the window.
bool try_change(FrameContext& f, const std::function<void(Settings&)>& change) {
  Settings changed = f.settings;
  try {
    change(changed);
    if (changed.lights.only >= 0 &&
        changed.lights.only >= static_cast<int>(all_lights_of(changed, f.input.scene).size()))
      changed.lights.only = -1;  // it is gone
    require_valid(changed, {f.input.features});
  } catch (const Error& e) {
    f.state.notice = e.what();
    return false;
  }
  f.settings = std::move(changed);
  return true;
}

}  // namespace

void say(FrameContext& f, Sentence sentence) {
  f.state.caption = Caption{std::move(sentence), f.input.seconds + kCaptionSeconds};
}

void edit(FrameContext& f, const std::function<void(Settings&)>& change) {
  const Settings before = f.settings;
  if (!try_change(f, change)) return;
  Sentence sentence = describe_change(before, f.settings);
  if (!sentence.text.empty()) say(f, std::move(sentence));
}

namespace {
// The next row that makes sense as things stand: `rig` needs a rig's file first.
void step_choice(const Option& o, Settings& s, int step, FeatureSet features) {
  for (size_t tries = 0; tries < o.values.size(); ++tries) {
    cycle(o, s, step, features);
    if (validate(s, {features}).empty()) return;
  }
}
}  // namespace

void edit_option(FrameContext& f, const Option& o, const OptionValue& value) {
  const Settings before = f.settings;
  const bool done = try_change(f, [&](Settings& s) {
    o.set(s, value, o);
    if (o.implies) o.implies(s);
  });
  if (!done) return;
  if (o.get(before) != o.get(f.settings)) say_step(f, o, before);
}

void edit_option_as_typed(FrameContext& f, const Option& o, const std::string& text) {
  try {
    edit_option(f, o, o.kind == Kind::text ? OptionValue(text) : parse_value(text, o.path));
  } catch (const Error& e) {
    f.state.notice = e.what();
  }
}

void step_option(FrameContext& f, const Option& o, int step) {
  const Settings before = f.settings;
  const bool done = try_change(f, [&](Settings& s) {
    go_on_from(f, o, s);
    if (o.kind == Kind::choice)
      step_choice(o, s, step, f.input.features);
    else if (o.kind == Kind::integer)
      o.set(s, next_power(static_cast<int>(std::get<Number>(o.get(s)).value), step, static_cast<int>(o.max)), o);
    if (o.implies) o.implies(s);
  });
  if (done) say_step(f, o, before);
}

bool replace_settings(FrameContext& f, const Settings& by) {
  try {
    require_valid(by, {f.input.features});
    if (by.lights.source == LightSource::rig) all_lights_of(by, f.input.scene);  // its file may be gone
  } catch (const Error& e) {
    f.state.notice = e.what();
    return false;
  }
  const glm::ivec2 size = f.settings.size;
  f.settings = by;
  f.settings.size = size;
  f.state.glide.reset();
  f.state.before_glide.reset();
  f.state.show_distance = f.state.playing = false;
  return true;
}

void choose_preset(FrameContext& f, int index) {
  const int n = static_cast<int>(presets().size());
  const Preset& chosen = presets()[(index + n) % n];
  if (replace_settings(f, chosen.make()))
    say(f, {fmt::format("Preset: {}. {}.", chosen.label, capitalised(chosen.help)), ""});
}

void show_view(FrameContext& f, View v) {
  const bool again = f.state.large && f.chosen() == v;
  f.settings.view.main = row(v).id;
  f.state.large = !again;
  turn_panels(f.state, v);
}

namespace {
constexpr size_t kViewsOfAPage = 8;

// What the first page has no place for and these settings can show.
std::vector<View> further_views(const Settings& stored) {
  std::vector<View> out;
  for (const ViewRow& v : views())
    if (v.view >= View::position && !needs_truth(v.view) && why_missing(v.view, stored).empty()) out.push_back(v.view);
  return out;
}
}  // namespace

size_t pages_of(const Settings& stored) {
  return 1 + (further_views(stored).size() + kViewsOfAPage - 1) / kViewsOfAPage;
}

std::vector<LookOf> page_of(const Settings& stored, size_t page) {
  const std::vector<View> all = further_views(stored);
  if (page == 0 || (page - 1) * kViewsOfAPage >= all.size()) return {};
  std::vector<LookOf> out;
  for (size_t i = (page - 1) * kViewsOfAPage; i < std::min(all.size(), page * kViewsOfAPage); ++i)
    out.push_back({row(all[i]).id, {}});
  return out;
}

void open_lesson(State& state, Settings& settings, LessonPlace place) {
  state.lesson = LessonRun{std::move(place.lesson)};
  close_panels(state, {Place::over, Place::whole, Place::edge});
  show_step(state, settings, place.step);
}

void show_step(State& state, Settings& settings, size_t step) {
  LessonRun& run = *state.lesson;
  const glm::ivec2 size = settings.size;
  std::string main = "final";  // a step without a view keeps the one before: still a function of the file alone
  for (size_t i = 0; i <= step; ++i)
    if (!run.lesson.steps[i].view.empty()) main = run.lesson.steps[i].view;
  settings = settings_at(run.lesson, step);
  settings.size = size;
  settings.view.main = main;
  run.step = step;
  run.revealed = false;
  state.large = run.lesson.steps[step].large;
  state.playing = state.show_distance = false;
  state.glide.reset();
  state.before_glide.reset();
  state.caption.reset();
}

void advance_motion(FrameContext& f) {
  State& s = f.state;
  // A slow frame must not throw the camera across the scene: a step is a quarter of a second at most.
  const double dt = s.last_seconds < 0 ? 0 : std::clamp(f.input.seconds - s.last_seconds, 0.0, 0.25);
  s.last_seconds = f.input.seconds;
  if (s.playing) f.settings.time_s += dt;
  const Motion motion = letters_are_a_panels(s) || typing(f) ? Motion{} : motion_of(f.input.held);
  s.camera_key = motion.any();
  if (s.camera_key) {
    s.glide.reset();
    f.settings.camera = moved(f.settings.camera, motion, speed_in(f.input.scene.bounds) * dt);
  }
  if (!s.glide) return;
  const double t = f.input.still ? 1 : (f.input.seconds - s.glide->start) / kGlideSeconds;
  f.settings.camera = between(s.glide->from, s.glide->to, std::clamp(t, 0.0, 1.0));
  if (t >= 1) s.glide.reset();
}

}  // namespace gbl::ui
