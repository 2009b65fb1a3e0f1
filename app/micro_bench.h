#pragma once
// What one (pixel, light) pair costs on this device, by what the pair is made of: the slope of whole frames over the number
// of lights, so that nothing that a pixel pays once is in it. Beside it the arithmetic alone, as C++ on all processors.
#include <optional>
#include <string>
#include <vector>

#include "renderer/frame/validate.h"
#include "renderer/passes/frame.h"

namespace gbl {

struct MicroRow {
  std::string group, what;              // "method", "by a cluster's list"
  double ns_per_pair = 0;               // of the frame; may come out below 0 where the clock is coarse
  std::optional<double> arithmetic_ns;  // none: not written in C++, or the processor is too old
};

// Every light reaches every pixel of `scene`, which must fill the picture; s: size and what else is not varied.
std::vector<MicroRow> run_micro_bench(Renderer&, const GpuScene& scene, const Settings& s, const DeviceLimits&);

}  // namespace gbl
