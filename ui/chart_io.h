#pragma once
// What the chart and the app tell each other.
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "renderer/options/settings.h"
#include "renderer/study/rows/study_row.h"

namespace gbl::ui {

// What the chart shows: rows of a study in the scene and with the truth at hand, and set-ups that were tried by hand.
struct ChartInput {
  struct Study {
    std::string id, label;
    std::string x, y, family;  // of its chart, unless another is asked for
  };
  std::vector<Study> studies;      // that can run here
  std::vector<StudyRow> rows;      // as renderer/study/study.h makes them, failed ones among them
  std::vector<Settings> settings;  // of each row, as asked for
  std::optional<size_t> current;   // the row of the settings at hand; empty: not measured yet
  bool measuring = false;          // the settings at hand are being measured
  glm::ivec2 size{0};              // at which rows are measured

  std::string running;                 // a study's id; empty: none runs
  size_t done = 0, total = 0;          // of the one that runs, or else of the one that is shown
  std::optional<double> seconds_left;  // empty: nobody knows yet
  std::string note;                    // why a study stopped or left cases out; empty = nothing to say
};

// What it asks to be measured.
struct ChartRequest {
  bool open = false;               // the settings at hand are to be measured
  std::string study;               // whose rows are to be shown; empty = not chosen yet
  bool run = false, stop = false;  // that study; any that runs
};

}  // namespace gbl::ui
