#include "renderer/study_row.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/settings_json.h"

namespace gbl {
namespace {

// clang-format off
constexpr Column kErrors[] = {
  {"over_1_255_display", "", "share of pixels whose largest channel is off by more than 1/255 as displayed"},
  {"over_half_255_display", "", "the same for 0.5/255"},
  {"over_1_255_linear", "", "the same for 1/255 of linear radiance"},
  {"max_linear", "radiance", "largest difference of a channel"},
  {"p99_linear", "radiance", "99th percentile of it"},
  {"rmse_linear", "radiance", "root mean square"},
  {"mae_linear", "radiance", "mean absolute difference"},
  {"signed_mean_linear", "radiance", "mean difference: dark is negative"},
  {"relmse_linear", "", "mean squared difference over squared radiance + 0.01"},
  {"psnr_display", "dB", "peak signal-to-noise ratio as displayed"},
  {"flip_mean", "", "mean perceptual difference (Andersson et al. 2020)"},
  {"normal_deg_mean", "degrees", "angle to the true normal, mean"},
  {"normal_deg_p50", "degrees", "median"},
  {"normal_deg_p99", "degrees", "99th percentile"},
  {"normal_deg_max", "degrees", "largest"},
  {"position_mean", "units", "distance to the true point, mean"},
  {"position_p99", "units", "99th percentile"},
  {"position_max", "units", "largest"},
  {"nonfinite_pixels", "", "pixels with NaN or infinity"},
  {"lost_pixels", "", "pixels with less than half their light"},
  {"doubled_pixels", "", "pixels with more than one and a half times their light"},
  {"background_lit_pixels", "", "pixels without a surface that are lit"},
};
// clang-format on

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

void append_times(Json& row, const Timing& timing) {
  for (const auto& [pass, ms] : timing.pass_ms) {
    if (ms.empty()) continue;
    const TimeSpread t = spread_of(ms);
    row[fmt::format("time_ms_{}_median", pass)] = t.median;
    row[fmt::format("time_ms_{}_p10", pass)] = t.p10;
    row[fmt::format("time_ms_{}_p90", pass)] = t.p90;
  }
}

}  // namespace

std::span<const Column> error_columns() { return kErrors; }

TimeSpread spread_of(std::vector<double> ms) {
  std::sort(ms.begin(), ms.end());
  const auto at = [&](double share) {
    const auto rank = static_cast<size_t>(std::ceil(share * static_cast<double>(ms.size())));
    return ms[std::max<size_t>(rank, 1) - 1];
  };
  return {at(0.5), at(0.1), at(0.9)};
}

bool measured_enough(int frames, double seconds, double slowest_s) {
  if (frames >= 20) return true;
  return seconds >= 20 && frames >= (slowest_s > 20 ? 1 : 3);
}

Json study_row(const FrameReport& r, const Timing& timing, const Machine& machine) {
  Json row;
  for (const Column& c : kErrors) row[c.id] = nullptr;
  append_times(row, timing);
  row["frames"] = timing.frames;
  row["time_source"] = r.time_source;
  row["pairs_tested"] = r.pairs ? Json(r.pairs->tested) : Json(nullptr);
  row["pairs_shaded"] = r.pairs ? Json(r.pairs->shaded) : Json(nullptr);
  row["pairs_lit"] = r.pairs ? or_null(r.pairs->lit) : Json(nullptr);
  row["bytes_per_pixel"] = r.gbuffer_bytes_per_pixel;
  row["accumulation_bytes_per_pixel"] = r.accumulation_bytes_per_pixel;
  row["mib"] = r.mib;
  row["draw_calls"] = r.draw_calls;
  row["driver"] = machine.driver;
  row["device"] = machine.device;
  row["size"] = fmt::format("{}x{}", r.size.x, r.size.y);
  row["settings"] = to_json(r.drawn);
  return row;
}

}  // namespace gbl
