#pragma once
// Time and memory as one thing grows and the rest stays: lights, pixels, overlap of lights, triangles.
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/lab.h"

namespace gbl {

struct GrowthAxis {
  const char* id;
  const char* label;
  const char* help;
  std::vector<double> values;
  void (*set)(Settings&, double value);
  // Where a frame stands on the axis; empty: nowhere, for no light reaches anything, or nobody has counted.
  std::optional<double> (*place)(const Settings&, const FrameReport&, double value);
  std::vector<std::string_view> chooses;                          // options that cannot be given beside it
  std::shared_ptr<const Scene> (*scene)(double value) = nullptr;  // null: the one that is open
};
std::span<const GrowthAxis> growth_axes();
const GrowthAxis& growth_axis(std::string_view id);  // Error(bad_input) with the known ones

struct GrowthRow {
  double x = 0;                                       // GrowthAxis::place
  double total_ms = 0, geometry_ms = 0, rest_ms = 0;  // medians; the lists of lights made anew in each frame
  double tested_per_pixel = 0;
  double targets_mib = 0, resident_mib = 0;  // of the frame; of the process
  double upload_ms = 0;                      // from a scene in memory to one on the GPU; 0: it was there
};
// Point by point; `done` after each.
std::vector<GrowthRow> measure_growth(Lab&, const Settings&, const GrowthAxis&, int frames,
                                      const std::function<void(const GrowthRow&)>& done);

// As a chart on logarithmic axes: the whole frame, its fill and all that follows. For run_gnuplot().
std::string growth_script(const GrowthAxis&, std::span<const GrowthRow>, const std::string& subtitle);

}  // namespace gbl
