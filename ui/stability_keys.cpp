// The stability panel's own keys.
#include <fmt/format.h>

#include "ui/commands.h"
#include "ui/stability_view.h"

namespace gbl::ui {
namespace {

size_t curve_count(const FrameContext& f) {
  const SweepResult* result = stability_input(f).result;
  return result ? result->curves.size() : 0;
}

void step_sweep(FrameContext& f, const KeyEvent& e) {
  StabilityState& s = f.state.stability;
  const size_t n = sweeps().size();
  s.sweep = (s.sweep + (e.shift ? n - 1 : 1)) % n;
  s.curve = 0;
  s.hidden.clear();
  s.log_y.reset();
}

void run_or_stop(FrameContext& f, const KeyEvent&) {
  const bool running = stability_input(f).running;
  f.state.stability.run = !running, f.state.stability.stop = running;
}

void select_curve(FrameContext& f, const KeyEvent& e) {
  if (const size_t n = curve_count(f); n > 0)
    f.state.stability.curve = (f.state.stability.curve + (e.key == "Up" ? n - 1 : 1)) % n;
}

// 1 … 8 are the first eight, with Shift the next.
void switch_curve(FrameContext& f, const KeyEvent& e) {
  const auto number = static_cast<size_t>(e.key[0] - '1') + (e.shift ? 8 : 0);
  std::set<size_t>& hidden = f.state.stability.hidden;
  if (number < curve_count(f) && hidden.erase(number) == 0) hidden.insert(number);
}

void toggle_log(FrameContext& f, const KeyEvent&) { f.state.stability.log_y = !sweep_axes(f).y.logarithmic; }

constexpr PanelKey kKeys[] = {
    {"R", "run or stop", run_or_stop},
    {"S", "next sweep (Shift: previous)", step_sweep},
    {"↑ ↓", "choose a curve", select_curve, "Up Down", true},
    {"1-8", "show or hide one (Shift: 9-16)", switch_curve, "1 2 3 4 5 6 7 8"},
    {"L", "log y", toggle_log},
    {"F4", "close", toggle_stability, ""},  // its row in the table of all keys answers
};

}  // namespace

std::span<const PanelKey> stability_keys() { return kKeys; }
bool press_in_stability(FrameContext& f, const KeyEvent& e) { return press_in_panel(f, e, kKeys); }
void toggle_stability(FrameContext& f, const KeyEvent&) { toggle_side(f.state, f.state.stability.open); }

const Sweep& chosen_sweep(const FrameContext& f) { return sweeps()[f.state.stability.sweep]; }

// Not what is shown still of the sweep before.
const StabilityInput& stability_input(const FrameContext& f) {
  static const StabilityInput kNone;
  const StabilityInput* in = f.input.stability;
  const bool other = in && in->result && in->result->sweep->id != std::string_view(chosen_sweep(f).id);
  return in && !other ? *in : kNone;
}

}  // namespace gbl::ui
