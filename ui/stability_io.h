#pragma once
// What the stability panel and the app tell each other.
#include <optional>
#include <string>
#include <vector>

#include "renderer/study/stability/stability.h"

namespace gbl::ui {

// What the stability panel shows of the sweep that it asked for.
struct StabilityInput {
  const SweepResult* result = nullptr;           // its points so far; null: not begun
  std::vector<std::vector<std::string>> stated;  // of each curve, judged or not yet
  size_t done = 0, total = 0;                    // points
  bool running = false;
  std::optional<double> seconds_left;  // empty: nobody knows yet
  std::string note;                    // why it stopped, or what it leaves out; empty = nothing to say
};

// What it asks to be measured.
struct StabilityRequest {
  bool open = false;  // closed: nothing of it runs
  std::string sweep;  // that is shown
  bool run = false, stop = false;
};

}  // namespace gbl::ui
