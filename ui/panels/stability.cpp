// F4: one parameter moved through the place where a method breaks. Its row and its keys.
#include <fmt/format.h>
#include <utility>

#include "ui/panels/stability_view.h"

namespace gbl::ui {
namespace {

size_t curve_count(const FrameContext& f) {
  const SweepResult* result = stability_input(f).result;
  return result ? result->curves.size() : 0;
}

void step_sweep(FrameContext& f, const KeyEvent& e) {
  StabilityState& s = f.state.of<StabilityState>();
  const size_t n = sweeps().size();
  s.sweep = (s.sweep + (e.shift ? n - 1 : 1)) % n;
  s.curve = 0;
  s.hidden.clear();
  s.log_y.reset();
}

void run_or_stop(FrameContext& f, const KeyEvent&) {
  const bool running = stability_input(f).running;
  f.state.of<StabilityState>().run = !running, f.state.of<StabilityState>().stop = running;
}

void select_curve(FrameContext& f, const KeyEvent& e) {
  if (const size_t n = curve_count(f); n > 0)
    f.state.of<StabilityState>().curve = (f.state.of<StabilityState>().curve + (e.key == "Up" ? n - 1 : 1)) % n;
}

// 1 … 8 are the first eight, with Shift the next.
void switch_curve(FrameContext& f, const KeyEvent& e) {
  const auto number = static_cast<size_t>(e.key[0] - '1') + (e.shift ? 8 : 0);
  std::set<size_t>& hidden = f.state.of<StabilityState>().hidden;
  if (number < curve_count(f) && hidden.erase(number) == 0) hidden.insert(number);
}

void toggle_log(FrameContext& f, const KeyEvent&) { f.state.of<StabilityState>().log_y = !sweep_axes(f).y.logarithmic; }

constexpr PanelKey kKeys[] = {
    {"R", "run or stop", run_or_stop},
    {"S", "next sweep (Shift: previous)", step_sweep},
    {"Up Down", "choose a curve", select_curve, true},
    {"1-8", "show or hide one (Shift: 9-16)", switch_curve},
    {"L", "log y", toggle_log},
    {"F4", "close", nullptr},
};

void ask(FrameContext& f) {
  StabilityState& s = f.state.of<StabilityState>();
  f.requests.stability = {s.open, chosen_sweep(f).id, std::exchange(s.run, false), std::exchange(s.stop, false)};
}

}  // namespace

extern const Panel kStabilityPanel = {
    .key = "F4",
    .id = "stability",
    .help = "stability: one parameter through the place where methods break, a curve each, its statement checked",
    .place = Place::beside,
    .box = side_box,
    .draw = draw_stability,
    .keys = kKeys,
    .make = make_panel_state<StabilityState>,
    .update = ask};

const Sweep& chosen_sweep(const FrameContext& f) { return sweeps()[f.state.of<StabilityState>().sweep]; }

// Not what is shown still of the sweep before.
const StabilityInput& stability_input(const FrameContext& f) {
  static const StabilityInput kNone;
  const StabilityInput* in = f.input.stability;
  const bool other = in && in->result && in->result->sweep->id != std::string_view(chosen_sweep(f).id);
  return in && !other ? *in : kNone;
}

}  // namespace gbl::ui
