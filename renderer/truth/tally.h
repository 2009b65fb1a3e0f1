#pragma once
// Numbers collected pixel by pixel, in one order: equal pictures give equal bits.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace gbl {

class Mean {
 public:
  void add(double value) { sum_ += value, ++count_; }
  std::optional<double> value() const {
    return count_ == 0 ? std::nullopt : std::optional(sum_ / static_cast<double>(count_));
  }

 private:
  double sum_ = 0;
  size_t count_ = 0;
};

// Of numbers that are not negative. One that is not finite makes the maximum infinite and is otherwise left out. A tie
// (ties.h) that is finite is left out of the maximum.
class Tally {
 public:
  void add(double value, bool tie = false) {
    if (std::isfinite(value)) {
      finite_.push_back(value), mean_.add(value);
      if (!tie) largest_ = std::max(largest_.value_or(value), value);
    } else {
      largest_ = std::numeric_limits<double>::infinity();
    }
  }
  std::optional<double> mean() const { return mean_.value(); }
  std::optional<double> max() const { return largest_; }

  // Nearest rank: a value that was measured, never one between two. 0 < share <= 1. Reorders what is kept.
  std::optional<double> percentile(double share) {
    if (finite_.empty()) return std::nullopt;
    const auto rank = static_cast<size_t>(std::ceil(share * static_cast<double>(finite_.size())));
    const auto at = finite_.begin() + static_cast<std::ptrdiff_t>(std::max<size_t>(rank, 1) - 1);
    std::nth_element(finite_.begin(), at, finite_.end());
    return *at;
  }

 private:
  std::vector<double> finite_;
  Mean mean_;
  std::optional<double> largest_;
};

}  // namespace gbl
