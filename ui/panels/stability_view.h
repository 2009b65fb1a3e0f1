#pragma once
// What the stability panel shows in a frame: a sweep's curves on its axes, and what is stated of them in order.
#include <set>

#include "ui/panels/side_panel.h"
#include "ui/plot.h"

namespace gbl::ui {

struct StabilityState : PanelState {
  size_t sweep = 0;                // of the table
  size_t curve = 0;                // selected
  std::optional<bool> log_y;       // empty: as the values ask for
  std::set<size_t> hidden;         // curves
  bool run = false, stop = false;  // asked for in this frame
};

const StabilityInput& stability_input(const FrameContext&);  // an empty one where nothing is ever measured
const Sweep& chosen_sweep(const FrameContext&);
void draw_stability(FrameContext&, Painter&, const Box&);

// The error's axis. Values that are not finite stand at its upper end.
struct SweepAxes {
  ChartAxis x, y;
  bool not_finite = false;  // there are such values
};
SweepAxes sweep_axes(const FrameContext&);

bool curve_on(const StabilityState&, size_t curve);
SeriesLook curve_look(size_t curve);

// One statement: of the selected curve first, then those that do not hold.
struct StatedLine {
  size_t curve;
  std::string text;
  enum class Mark { open, holds, fails, not_drawn } mark;
};
std::vector<StatedLine> stated_lines(const FrameContext&);

void draw_sweep_curves(FrameContext&, Painter&, Plot&);
void draw_sweep_families(FrameContext&, Painter&, const Box&);  // bars instead of curves

}  // namespace gbl::ui
