#pragma once
// What the stability panel and the advisor remember between frames.
#include <optional>
#include <set>
#include <string>

namespace gbl::ui {

struct StabilityState {
  bool open = false;
  size_t sweep = 0;                // of the table
  size_t curve = 0;                // selected
  std::optional<bool> log_y;       // empty: as the values ask for
  std::set<size_t> hidden;         // curves
  bool run = false, stop = false;  // asked for in this frame
};

struct AdvisorState {
  bool open = false;
  double codes = 1;  // of 255
  bool every_pixel = false;
  size_t cost = 1;                 // of the costs' table: bytes
  size_t first = 0, shown = 0;     // of what is left out: the first on screen, and how many in the last frame
  bool run = false, stop = false;  // asked for in this frame
};

}  // namespace gbl::ui
