#pragma once
// What the chart's panel remembers between frames.
#include <optional>
#include <set>
#include <string>

#include "ui/plot.h"

namespace gbl::ui {

struct ChartState {
  bool open = false;
  std::string study = "tradeoff";
  std::string x = "time_ms_total_median", y = "over_1_255_display";  // columns
  size_t family = 0;                                                 // of the family paths
  std::optional<bool> log_x, log_y;                                  // empty: as the column asks for
  bool front = true;
  std::set<std::string> hidden;        // families
  std::optional<Span> zoom_x, zoom_y;  // empty: everything
  std::string selected;                // a row's key; empty = none
  bool run = false, stop = false;      // asked for in this frame
};

}  // namespace gbl::ui
