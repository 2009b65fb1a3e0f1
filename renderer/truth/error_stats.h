#pragma once
// What the error view found over the whole picture: its numbers, its histogram and the bar that its colours mean.
#include <array>
#include <vector>

#include "renderer/inspect/views.h"

namespace gbl {

struct ErrorStats {
  ErrorOf of = ErrorOf::final;
  size_t compared = 0, nonfinite = 0;  // pixels with a surface; of those, pixels that are no finite number
  double max = 0, mean = 0, p99 = 0;   // of magnitudes, in the unit of `of`
  double signed_mean = 0;
  glm::ivec2 worst{-1};  // origin top left; -1: nothing compared
  double range = 1;      // where the colour bar ends
  static constexpr int kBins = 32;
  std::array<size_t, kBins> histogram{};  // of magnitudes, equal bins over 0 ... range; the last holds all beyond
};

const char* unit_of(ErrorOf);  // "codes of 255", "degrees", …

// errors: RGBA floats, rows bottom to top; r = signed error, a = 1 where a surface is. fixed_range 0: the bar ends
// where 99.9 % of the pixels are within it, rounded up so that its labels are round.
ErrorStats error_stats(ErrorOf, glm::ivec2 size, const std::vector<float>& errors, double fixed_range);

// The numbered bar: magnitude from 0, or both ways.
Legend error_legend(const ErrorStats&, ErrorScale);

}  // namespace gbl
