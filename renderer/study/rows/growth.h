#pragma once
// How a cost grows with what it is asked for: the power between neighbouring points, and where it bends.
#include <optional>
#include <span>
#include <vector>

namespace gbl {

struct GrowthPoint {
  double x = 0, cost = 0;  // both above 0; x rising
};

// Between each point and the next: 1 is in proportion, 0 is no growth.
std::vector<double> growth_powers(std::span<const GrowthPoint>);

// Where the cost begins to go with x: the power stays above one half from there to the end. Empty: it never does. The first
// point's x: it does from the beginning.
std::optional<double> growth_bend(std::span<const GrowthPoint>);

}  // namespace gbl
