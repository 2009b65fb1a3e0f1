#pragma once
// What the pitfalls' panel and the app tell each other.
#include <optional>
#include <string>
#include <vector>

#include "renderer/study/pitfalls/judge.h"

namespace gbl::ui {

// The numbers of the entry that is open, as far as they are measured.
inline constexpr size_t kPathPoints = 17;

struct PitfallInput {
  std::string id;
  std::optional<double> broken, fixed, blind;
  // Along its path, at equal steps: the first so many are there.
  std::vector<double> path_broken, path_fixed;
  bool running = false;
  std::string note;  // why there is none, or what is not as catalogued
};

struct PitfallRequest {
  std::string id;  // of the entry that is open; empty: none
};

}  // namespace gbl::ui
