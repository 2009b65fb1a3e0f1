#pragma once
// What the tests of normal encodings measure with: directions, and the errors of storing them.
#include <algorithm>

#include "renderer/base/random.h"
#include "renderer/gbuffer/normal_encoding.h"
#include "tests/test_support.h"

namespace gbl {

// Float noise of a decoded direction: a few roundings of 2^-24 radians each, in degrees.
inline constexpr double kFloatNoiseDeg = 1.5e-5;
// The columns have three digits.
inline constexpr double kHalfADigit = 1.005;

inline const std::vector<glm::dvec3>& directions() {
  static const std::vector<glm::dvec3> all = fibonacci_sphere(1 << 20);
  return all;
}

// The directions that the row's pitfall strikes; a test of their own says what becomes of them.
inline bool lost(NormalEncoding e, const glm::dvec3& n) { return row_of(e).lost && row_of(e).lost(n); }

struct Errors {
  Degrees degrees{};
  std::vector<std::pair<double, glm::dvec3>> worst;  // the 1024 worst directions
};

template <class Store, class Leave>
Errors measure(Store store, Leave leave_out) {
  std::vector<std::pair<double, int>> errors;
  errors.reserve(directions().size());
  Errors out;
  for (size_t i = 0; i < directions().size(); ++i) {
    const glm::dvec3& n = directions()[i];
    if (leave_out(n)) continue;
    errors.emplace_back(angle_deg(n, glm::dvec3(store(n))), static_cast<int>(i));
    out.degrees.mean += errors.back().first;
  }
  out.degrees.mean /= static_cast<double>(errors.size());
  std::sort(errors.begin(), errors.end());
  out.degrees.p99 = errors[errors.size() * 99 / 100].first;
  out.degrees.max = errors.back().first;
  for (auto e = errors.rbegin(); e != errors.rbegin() + 1024; ++e)
    out.worst.emplace_back(e->first, directions()[e->second]);
  return out;
}
template <class Store>
Errors measure(Store store) {
  return measure(store, [](const glm::dvec3&) { return false; });
}

// A grid of 2^20 directions misses the worst one by a few per cent: climb from the worst it has.
template <class Store>
double climbed(const Errors& errors, Store store) {
  Pcg32 random(1);
  double top = 0;
  for (auto [error, n] : errors.worst) {
    double step = 1e-3;  // the grid's spacing is 3.5e-3
    for (int failures = 0; step > 1e-8;) {
      const glm::dvec3 away(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1));
      const glm::dvec3 next = glm::normalize(n + step * away);
      const double next_error = angle_deg(next, store(next));
      if (next_error > error) {
        error = next_error;
        n = next;
        failures = 0;
      } else if (++failures > 30) {
        step /= 2;
        failures = 0;
      }
    }
    top = std::max(top, error);
  }
  return top;
}

}  // namespace gbl
