#pragma once
// What the error view found over the whole picture: its numbers, its histogram and the bar that its colours mean.
#include <array>
#include <vector>

#include "renderer/inspect/views.h"
#include "renderer/truth/truth.h"

namespace gbl {

struct ErrorStats {
  ErrorOf of = ErrorOf::final;
  size_t compared = 0, nonfinite = 0;  // pixels with a surface; of those, pixels that are no finite number
  size_t ties = 0;                     // and pixels at an edge (ties.h): left out of `max` and `worst` alone
  double max = 0, mean = 0, p99 = 0;   // of magnitudes, in the unit of `of`
  double signed_mean = 0;
  glm::ivec2 worst{-1};  // origin top left; -1: nothing compared
  double range = 1;      // where the colour bar ends
  static constexpr int kBins = 32;
  std::array<size_t, kBins> histogram{};  // of magnitudes, equal bins over 0 ... range; the last holds all beyond
};

const char* unit_of(ErrorOf);  // "codes of 255", "degrees", …

// The error view's colour of ties. Of all colours it is nearly the farthest from both bars, the background and what is no
// number, for all kinds of colour vision alike (the test has the numbers).
inline constexpr glm::vec3 kTieColour{0.1f, 1, 0};

// Errors are RGBA floats, rows bottom to top: the signed error; object and triangle that the frame shows (SeenSurface);
// a = 1 where a surface is, kTie at ties.
inline constexpr float kTie = 2;
// Marks them, but for those that are no finite number. True if there is one.
bool mark_ties(const Truth&, std::vector<float>& errors);

// fixed_range 0: the bar ends where 99.9 % of the pixels are within it, rounded up so that its labels are round.
ErrorStats error_stats(ErrorOf, glm::ivec2 size, const std::vector<float>& errors, double fixed_range);

// The numbered bar: magnitude from 0, or both ways.
Legend error_legend(const ErrorStats&, ErrorScale);

}  // namespace gbl
