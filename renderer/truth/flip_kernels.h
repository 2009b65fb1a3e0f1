#pragma once
// The filters of FLIP (Andersson et al. 2020): what an eye at this distance still tells apart, and what draws it.
#include <array>
#include <vector>

#include "renderer/truth/separable_filter.h"

namespace gbl {

// One round Gaussian of a contrast sensitivity; `along` sums to 1, the shares of a channel's terms sum to 1.
struct SensitivityTerm {
  double share;
  Kernel along;  // x and y alike
};

// Of the channels black-white, red-green and blue-yellow, in this order.
std::array<std::vector<SensitivityTerm>, 3> sensitivity_kernels(double pixels_per_degree);

// Along one axis; `smooth` is the other axis' part. Positive weights sum to 1, negative ones to -1.
struct FeatureKernels {
  Kernel smooth, edge, point;
};
FeatureKernels feature_kernels(double pixels_per_degree);

}  // namespace gbl
