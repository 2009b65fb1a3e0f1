#include "renderer/truth/separable_filter.h"

#include <algorithm>

namespace gbl {
namespace {

void add_scaled(double* sum, const double* values, double weight, int count) {
  for (int i = 0; i < count; ++i) sum[i] += weight * values[i];
}

// One row with `radius` copies of its first and last pixel beside it.
void pad_row(std::vector<double>& padded, const double* row, int width, int radius) {
  std::fill_n(padded.begin(), radius, row[0]);
  std::copy_n(row, width, padded.begin() + radius);
  std::fill_n(padded.begin() + radius + width, radius, row[width - 1]);
}

}  // namespace

// Tap by tap over a whole row: the sums of a row stay in the cache, and no tap asks whether it is inside.
Plane filtered_along_x(const Plane& in, const Kernel& kernel) {
  Plane out(in.size);
  const int radius = kernel.radius();
  std::vector<double> padded(static_cast<size_t>(in.size.x + 2 * radius));
  for (int y = 0; y < in.size.y; ++y) {
    pad_row(padded, in.row(y), in.size.x, radius);
    for (int tap = 0; tap <= 2 * radius; ++tap)
      add_scaled(out.row(y), padded.data() + tap, kernel.weights[tap], in.size.x);
  }
  return out;
}

Plane filtered_along_y(const Plane& in, const Kernel& kernel) {
  Plane out(in.size);
  const int radius = kernel.radius();
  for (int y = 0; y < in.size.y; ++y)
    for (int tap = 0; tap <= 2 * radius; ++tap) {
      const int source = std::clamp(y + tap - radius, 0, in.size.y - 1);
      add_scaled(out.row(y), in.row(source), kernel.weights[tap], in.size.x);
    }
  return out;
}

}  // namespace gbl
