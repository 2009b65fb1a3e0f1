#pragma once
// What the advisor and the app tell each other.
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "renderer/study/advice/advisor.h"

namespace gbl::ui {

// What the advisor panel shows: the answer found last, and how far the one asked for now has come.
struct AdvisorInput {
  std::optional<Advice> advice;  // the last complete one in this scene
  ErrorBudget budget;            // that it was asked for
  AdviceCost cost = AdviceCost::bytes;
  bool running = false;
  size_t tried = 0;      // set-ups and values so far, of the one that runs
  std::string progress;  // what it tries
  std::string note;      // why it stopped, or why its answer is an old one; empty = nothing to say
  glm::ivec2 size{0};    // at which set-ups are measured
};

// What it asks to be looked for.
struct AdvisorRequest {
  bool open = false;  // closed: nothing of it runs
  ErrorBudget budget;
  AdviceCost cost = AdviceCost::bytes;
  bool run = false, stop = false;
};

}  // namespace gbl::ui
