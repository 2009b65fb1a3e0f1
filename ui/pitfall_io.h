#pragma once
// What the pitfalls' panel and the app tell each other.
#include <cstdint>
#include <map>
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

// What the list shows beside an entry: both of its sides, small. As many as are drawn.
inline constexpr glm::ivec2 kPitfallPicture{160, 90};
struct PitfallPicture {
  uint64_t broken = 0, fixed = 0;  // ImTextureID; row 0 is the picture's bottom row
};
using PitfallPictures = std::map<std::string, PitfallPicture, std::less<>>;  // by id

struct PitfallRequest {
  std::string id;     // of the entry that is open; empty: none
  bool list = false;  // the list is open: its pictures are seen
};

}  // namespace gbl::ui
