#pragma once
// How much longer one of two takes, from rounds in which both were timed in turn: what slows the machine down slows both.
#include <cstddef>
#include <span>

namespace gbl {

struct PairedRatio {
  double median = 1, low = 1, high = 1;  // of b over a; low … high: where the median lies with 95 % confidence
};

inline constexpr size_t kLeastRounds = 6;  // that say anything with confidence

// One time of each per round, above 0; at least one round. The interval is that of order statistics, whatever the times are
// distributed like (Conover 1999, "Practical Nonparametric Statistics", section 3.2); of fewer than kLeastRounds it is all
// that was seen.
PairedRatio paired_ratio(std::span<const double> a, std::span<const double> b);

}  // namespace gbl
