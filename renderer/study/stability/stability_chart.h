#pragma once
// A sweep as a chart: the parameter to the right, the error upwards, a line per curve; families of configurations as
// bars. On a logarithmic axis 0 stands a decade below the smallest value, and what is not finite above the largest.
#include <string>

#include "renderer/study/stability/stability.h"

namespace gbl {

enum class StabilityFile { svg, png };
std::string stability_script(const SweepResult&, const std::string& device, StabilityFile);

// Of one curve's configurations of a family: what the bars and the table show.
struct FamilyShares {
  size_t configurations = 0;
  double wrong = 0;         // share of configurations with any pixel beyond the metric's bound
  double lost = 0;          // share of the lit pixels of all of them
  double worst_linear = 0;  // largest error of a pixel; may be infinite
};
FamilyShares family_shares(const CurveResult&, int family);

}  // namespace gbl
