#include "ui/commands.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "renderer/frame/frame_lights.h"
#include "renderer/frame/validate.h"
#include "renderer/opening/exposure_meter.h"
#include "renderer/options/presets.h"
#include "ui/camera_motion.h"
#include "ui/state.h"

namespace gbl::ui {
namespace {

constexpr float kScaleStep = 1.1f;

std::string light_sentence(const FrameContext& f, int index, const Light& light) {
  const double distance = distance_in_ranges(f.settings.camera, light);
  return fmt::format("Light {}: {} units up, range {:.0f}; the camera is {} its range, d/r {:.2f}.", index,
                     static_cast<int>(light.position.y), light.range, distance < 1 ? "inside" : "outside", distance);
}

int light_total(const FrameContext& f) { return static_cast<int>(all_lights_of(f.settings, f.input.scene).size()); }

// The light of that index of these settings, even while another one is alone.
std::optional<Light> light_at(const FrameContext& f, int index) {
  Settings all = f.settings;
  all.lights.only = -1;
  const std::vector<Light> lights = lights_of(all, f.input.scene);
  if (index < 0 || index >= static_cast<int>(lights.size())) return {};
  return lights[index];
}

}  // namespace

void show_all(FrameContext& f, const KeyEvent&) {
  State& s = f.state;
  const size_t pages = pages_of(f.stored);
  if (!std::exchange(s.large, false)) s.page = (s.page + 1) % pages;
  if (pages > 1) say(f, {fmt::format("Views, page {} of {}. 0 turns the page.", s.page + 1, pages), ""});
}

namespace {
// The settings as they were, said as a change to them.
void take_step(FrameContext& f, bool (History::*step)(Settings&), const char* none) {
  const Settings before = f.settings;
  if (!(f.state.history.*step)(f.settings)) return say(f, {none, ""});
  f.state.glide.reset();
  f.state.before_glide.reset();
  Sentence sentence = describe_change(before, f.settings);
  if (sentence.text.empty()) sentence.text = "As it was: the camera, or what is looked at.";
  say(f, std::move(sentence));
}
}  // namespace

void undo(FrameContext& f, const KeyEvent&) { take_step(f, &History::undo, "There is nothing to take back."); }
void redo(FrameContext& f, const KeyEvent&) { take_step(f, &History::redo, "Nothing was taken back."); }

void show_whole_picture(FrameContext& f, const KeyEvent&) { show_whole(f); }
void show_pixels(FrameContext& f, const KeyEvent&) { show_pixel_for_pixel(f); }

void step_channels(FrameContext& f, const KeyEvent&) {
  constexpr const char* kOrder[] = {"rgb", "r", "g", "b"};
  std::string shown;
  change_look(f, f.layout.main, [&](ViewLook& look) {
    const auto now = std::find(std::begin(kOrder), std::end(kOrder), look.channels);
    const size_t next = now == std::end(kOrder) ? 0 : static_cast<size_t>(now - kOrder + 1) % std::size(kOrder);
    shown = look.channels = kOrder[next];
  });
  say(f, {fmt::format("{}: channels {}.", row(f.layout.main).label, shown), ""});
}

void step_map(FrameContext& f, const KeyEvent&) {
  const int n = static_cast<int>(rows<ColourMap>().size());
  ColourMap map{};
  change_look(f, f.layout.main,
              [&](ViewLook& look) { map = look.map = static_cast<ColourMap>((static_cast<int>(look.map) + 1) % n); });
  say(f,
      {fmt::format("{}: colours: {}. {}.", row(f.layout.main).label, row(map).label, capitalised(row(map).help)), ""});
}

void fit_range(FrameContext& f, const KeyEvent&) {
  bool fit = false;
  change_look(f, f.layout.main, [&](ViewLook& look) {
    fit = look.fit = !look.fit;
    look.range.reset();
  });
  say(f, {fit ? "Black and white at the ends of what is seen." : "Black and white as the view has them.", ""});
}

void lock_view(FrameContext& f, const KeyEvent&) { lock_panel(f); }

void show_codes(FrameContext& f, const KeyEvent&) {
  const View v = f.layout.main;
  if (needs_truth(v)) return say(f, {fmt::format("{}: worked out, not stored: it has no codes.", row(v).label), ""});
  const bool raw = toggle_raw(f, v);
  say(f, {fmt::format("{}: {}.", row(v).label, raw ? "the stored codes, undecoded" : "decoded"), ""});
}

void toggle_histogram(FrameContext& f, const KeyEvent&) { f.state.histogram = !f.state.histogram; }

void next_preset(FrameContext& f, const KeyEvent& e) {
  const Preset* now = preset_of(f.settings);
  const int index = now ? static_cast<int>(now - presets().data()) : -1;
  if (!now && e.shift) return choose_preset(f, -1);
  // A preset that this device cannot draw is passed over, as a row of an axis is.
  const int n = static_cast<int>(presets().size());
  int next = index;
  do next = (next + (e.shift ? n - 1 : 1)) % n;
  while (!validate(presets()[static_cast<size_t>(next)].make(), {f.input.features}).empty());
  choose_preset(f, next);
}

void go_home(FrameContext& f, const KeyEvent&) {
  State& s = f.state;
  f.settings = s.initial;
  s.large_before = s.initial.view.main != "final";
  s.large = s.present || s.large_before;
  s.playing = s.show_distance = s.hidden = false;
  s.page = 0;
  close_panels(s, {Place::over, Place::whole});
  s.glide.reset();
  s.before_glide.reset();
  s.held_at.reset();
  s.lesson.reset();
  say(f, {"Home: everything is as it was loaded.", ""});
}

void glide(FrameContext& f, const KeyEvent&) {
  State& s = f.state;
  const std::optional<Light> light = light_at(f, f.settings.view.pick);
  if (!light) return say(f, {fmt::format("There is no light {} to glide into.", f.settings.view.pick), ""});
  const Camera from = f.settings.camera;
  if (s.before_glide) {
    s.glide = Glide{from, *s.before_glide, f.input.seconds};
    s.before_glide.reset();
  } else {
    s.glide = Glide{from, inside(from, *light), f.input.seconds};
    s.before_glide = from;
  }
  s.show_distance = true;
}

void solo_light(FrameContext& f, const KeyEvent&) {
  const int pick = f.settings.view.pick;
  const bool alone = f.settings.lights.only >= 0;
  if (!alone && pick >= light_total(f)) return say(f, {fmt::format("There is no light {} to show alone.", pick), ""});
  f.settings.lights.only = alone ? -1 : pick;
  say(f, {alone ? "All lights again." : fmt::format("Light {} alone.", pick), ""});
}

void pick_light(FrameContext& f, const KeyEvent& e) {
  const int n = light_total(f);
  if (n == 0) return say(f, {"There are no lights to pick from.", ""});
  const int step = e.key == "," ? -1 : 1;
  const int pick = (std::min(f.settings.view.pick, n - 1) + step + n) % n;
  f.settings.view.pick = pick;
  f.state.before_glide.reset();                                    // the next I glides into this one
  if (f.settings.lights.only >= 0) f.settings.lights.only = pick;  // alone stays alone
  if (const std::optional<Light> light = light_at(f, pick)) say(f, {light_sentence(f, pick, *light), ""});
}

void toggle_time(FrameContext& f, const KeyEvent&) {
  f.state.playing = !f.state.playing;
  say(f, {f.state.playing ? "The lights move: time runs." : fmt::format("Paused at t = {:.2f} s.", f.settings.time_s),
          ""});
}

void meter_light(FrameContext& f, const KeyEvent&) {
  if (!meter(f.settings, f.input.scene)) {
    f.state.notice = "no light reaches a surface that is seen: there is nothing to meter";
    return;
  }
  say(f, {fmt::format(
              "Exposure {:.3g}, metered on the surfaces that are seen; ambient light and backdrop keep their share.",
              f.settings.exposure),
          ""});
}

void pick_object(FrameContext& f, const KeyEvent&) {
  int& picked = f.settings.view.object;
  const std::optional<PixelProbe>& probe = f.input.probe;
  const bool pointed = probe && (f.state.held_at || f.state.hovered_pixel);
  const int now = pointed ? probe->object() : 0;
  const bool again = now == picked;
  picked = again ? 0 : now;
  if (picked > 0)
    say(f, {fmt::format("Picked: {}, object {} of {}.", object_name(*probe, f.input.scene), picked,
                        f.input.scene.instances.size()),
            ""});
  else
    say(f, {pointed || again ? "No object is picked." : "Point at an object or hold a pixel first.", ""});
}

void show_error(FrameContext& f, const KeyEvent& e) { show_view(f, e.shift ? View::reference : View::error); }

void go_to_worst(FrameContext& f, const KeyEvent&) {
  const std::optional<ErrorStats>& stats = f.input.error;
  if (f.layout.main != View::error || !stats || stats->worst.x < 0)
    return say(f, {"The error view is not the large one: U shows it.", ""});
  f.hold(stats->worst);
  say(f, {fmt::format("The worst pixel: {}, {} is off by {:.3g} {}.", stats->worst.x, stats->worst.y, stats->max,
                      unit_of(stats->of)),
          ""});
}

void toggle_presenting(FrameContext& f, const KeyEvent&) {
  State& s = f.state;
  s.present = !s.present;
  if (s.present) s.large_before = s.large;
  s.large = s.present || s.large_before;
}

void toggle_hidden(FrameContext& f, const KeyEvent&) { f.state.hidden = !f.state.hidden; }
void reload_shaders(FrameContext& f, const KeyEvent&) { f.requests.reload_shaders = true; }
void quit(FrameContext& f, const KeyEvent&) { f.requests.quit = true; }
void reveal_answer(FrameContext& f, const KeyEvent&) {
  if (f.state.lesson) f.state.lesson->revealed = true;
}
void toggle_white_figures(FrameContext& f, const KeyEvent&) {
  f.state.white_figures = !f.state.figures_on_white();
  say(f, {*f.state.white_figures ? "Figures stand on white." : "Figures stand on dark.", ""});
}

void toggle_theme(FrameContext& f, const KeyEvent&) {
  f.state.light = !f.state.light;
  use_theme(f.state.light ? kLightTheme : kDarkTheme);
  say(f,
      {fmt::format("The {} theme. Figures stand on {}.", theme().name, f.state.figures_on_white() ? "white" : "dark"),
       ""});
}

void toggle_navigation(FrameContext& f, const KeyEvent&) {
  ImGuiIO& io = ImGui::GetIO();
  io.ConfigFlags ^= ImGuiConfigFlags_NavEnableKeyboard;
  const bool on = io.ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard;
  ImGui::SetWindowFocus(on ? kRootWindow : nullptr);
  say(f, {on ? "Panel keys: Tab and arrows walk, Space presses, Esc leaves." : "Panel keys off.", ""});
}

void toggle_full_screen(FrameContext& f, const KeyEvent&) {
  f.requests.toggle_full_screen = true;
  say(f, {f.input.full_screen ? "A window again." : "Full screen. F11 makes it a window again.", ""});
}

void scale_type(FrameContext& f, const KeyEvent& e) {
  float& scale = f.state.ui_scale;
  scale = std::clamp(scale * (e.key == "+" ? kScaleStep : 1 / kScaleStep), kSmallestScale, kLargestScale);
  if (std::abs(scale - 1) < 0.01f) scale = 1;  // three up and three down is where we began
  say(f, {fmt::format("Type at {:.0f} %.", scale * 100), ""});
}

void nudge_pixel(FrameContext& f, const KeyEvent& e) {
  glm::ivec2 pixel = f.held_pixel().value_or(f.state.hovered_pixel.value_or(f.frame_size() / 2));
  const int by = e.shift ? 10 : 1;
  if (e.key == "Left") pixel.x -= by;
  if (e.key == "Right") pixel.x += by;
  if (e.key == "Up") pixel.y -= by;
  if (e.key == "Down") pixel.y += by;
  f.hold(pixel);
}

void stop_typing(FrameContext& f) {
  f.state.field.clear();
  ImGui::SetWindowFocus(nullptr);  // the field lets go of the keyboard, also if it has not seen the key itself
}

void close_top(FrameContext& f, const KeyEvent&) {
  State& s = f.state;
  ImGuiIO& io = ImGui::GetIO();
  if (io.ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard)
    io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
  else if (close_top_panel(s))
    return;
  else if (s.held_at)
    s.held_at.reset();
  else if (s.lesson)
    s.lesson.reset();
  else
    s.hidden = false;
}

}  // namespace gbl::ui
