#include "renderer/truth/error_stats.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/picture/colour_map.h"
#include "renderer/truth/ties.h"

namespace gbl {
namespace {
// A bar that fits holds so many of the pixels: one pixel at a silhouette must not turn all the others black.
constexpr double kFitShare = 0.999;
}  // namespace

const char* unit_of(ErrorOf of) {
  switch (of) {
    case ErrorOf::final: return "codes of 255";
    case ErrorOf::lit:
    case ErrorOf::diffuse_light:
    case ErrorOf::specular_light: return "radiance";
    case ErrorOf::normal: return "degrees";
    case ErrorOf::position:
    case ErrorOf::depth: return "units";
    case ErrorOf::albedo:
    case ErrorOf::roughness: return "of 1";
  }
  return "";
}

bool mark_ties(const Truth& truth, std::vector<float>& errors) {
  const auto width = static_cast<size_t>(truth.size.x), height = static_cast<size_t>(truth.size.y);
  bool marked = false;
  for (size_t i = 0; i < truth.pixels(); ++i) {
    float* e = &errors[4 * ((height - 1 - i / width) * width + i % width)];
    if (e[3] < 0.5f || !std::isfinite(e[0])) continue;
    if (!is_tie(truth, i, {static_cast<int>(e[1]), static_cast<int>(e[2])})) continue;
    e[3] = kTie, marked = true;
  }
  return marked;
}

ErrorStats error_stats(ErrorOf of, glm::ivec2 size, const std::vector<float>& errors, double fixed_range) {
  ErrorStats out;
  out.of = of;
  std::vector<double> magnitudes;
  double sum = 0, signed_sum = 0;
  const auto look_at = [&](glm::ivec2 pixel, double e, bool tie) {
    ++out.compared, out.ties += tie;
    const double magnitude = std::isfinite(e) ? std::abs(e) : INFINITY;
    if (!tie && (magnitude > out.max || out.worst.x < 0)) out.max = magnitude, out.worst = pixel;
    if (!std::isfinite(e)) {
      ++out.nonfinite;
      return;
    }
    sum += magnitude, signed_sum += e;
    magnitudes.push_back(magnitude);
  };
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const float* e =
          &errors[4 * (static_cast<size_t>(size.y - 1 - y) * static_cast<size_t>(size.x) + static_cast<size_t>(x))];
      if (e[3] > 0.5f) look_at({x, y}, e[0], e[3] == kTie);
    }
  if (magnitudes.empty()) return out;
  const auto n = static_cast<double>(magnitudes.size());
  out.mean = sum / n, out.signed_mean = signed_sum / n;
  std::sort(magnitudes.begin(), magnitudes.end());
  const auto percentile = [&](double share) { return magnitudes[static_cast<size_t>(std::ceil(share * n)) - 1]; };
  out.p99 = percentile(0.99);
  const double most = percentile(kFitShare) > 0 ? percentile(kFitShare) : magnitudes.back();
  out.range = fixed_range > 0 ? fixed_range : most > 0 ? round_for_bar(most) : 1;
  for (const double m : magnitudes)
    ++out.histogram[static_cast<size_t>(std::min(m / out.range * ErrorStats::kBins, ErrorStats::kBins - 1.0))];
  return out;
}

Legend error_legend(const ErrorStats& stats, ErrorScale scale) {
  const bool with_sign = scale == ErrorScale::with_sign;
  const std::span<const glm::vec3> stops = stops_of(with_sign ? ColourMap::diverging : ColourMap::magma);
  const size_t last = stops.size() - 1;
  const size_t step = with_sign ? last / 2 : last / 4;  // labels at both ends and at round parts between
  Legend bar{true, {}, {{"no surface", kSkyColour}}};
  if (stats.ties > 0) bar.apart.push_back({"edge: either surface", kTieColour});
  if (stats.nonfinite > 0) bar.apart.push_back({"not finite", {1, 0, 1}});
  for (size_t i = 0; i <= last; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(last);
    const double value = with_sign ? (2 * t - 1) * stats.range : t * stats.range;
    std::string label = i % step == 0 ? fmt::format("{:.3g}", value) : "";
    if (i == last) label += fmt::format(" {}", unit_of(stats.of));
    bar.entries.push_back({label, stops[i]});
  }
  return bar;
}

}  // namespace gbl
