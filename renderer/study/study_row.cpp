#include "renderer/study/study_row.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/base/size_text.h"
#include "renderer/options/settings_json.h"

namespace gbl {
namespace {

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

// JSON knows no infinity: a PSNR of equal pictures and the error of a picture that is not finite are written as text.
Json number_or_null(const std::optional<double>& value) {
  if (value && std::isinf(*value)) return *value > 0 ? "inf" : "-inf";
  return or_null(value);
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

void append_costs(Json& row, const FrameReport& r, const Machine& machine) {
  row["size"] = size_text(r.size);
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
}

Json study_row(const FrameReport& r, const Errors& errors, const Timing& timing, const Machine& machine) {
  Json row;
  for (const ErrorColumn& c : error_columns()) row[c.id] = number_or_null(errors.*c.value);
  append_times(row, timing);
  row["frames"] = timing.frames;
  append_costs(row, r, machine);
  row["settings"] = to_json(r.drawn);
  return row;
}

}  // namespace gbl
