// Light over distance with the settings' falloff and threshold, for two strengths: where it has really fallen to the threshold, and
// where the engine blog's shortcut (part 30) says that it has.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

#include "renderer/figures/drawing_parts.h"
#include "renderer/light/attenuation.h"
#include "renderer/picture/svg.h"

namespace gbl {
namespace {

constexpr double kStrengths[] = {1, 100};
constexpr const char* kDashes[] = {"", "7 4"};
constexpr double kLeft = 64, kRight = 24, kTop = 48, kBottom = 48, kWidth = 640, kHeight = 400;
constexpr int kSteps = 400;

struct Axes {
  double far;        // in ranges
  double low, high;  // powers of ten
  glm::dvec2 at(double x, double value) const {
    const double y = (std::log10(std::max(value, 1e-12)) - low) / (high - low);
    return {kLeft + x / far * (kWidth - kLeft - kRight),
            kHeight - kBottom - std::clamp(y, 0.0, 1.0) * (kHeight - kTop - kBottom)};
  }
};

std::string grid(const Axes& a, double step) {
  std::string out;
  for (int power = int(a.low); power <= int(a.high); ++power) {
    const double value = std::pow(10.0, power);
    out += svg_line(a.at(0, value), a.at(a.far, value), {"#ddd", 1});
    out += svg_text(a.at(0, value) + glm::dvec2(-8, 4), fmt::format("{:g}", value), SvgAnchor::end, 11, "#555");
  }
  for (int k = 0; k * step <= a.far; ++k)
    out += svg_text(a.at(k * step, 1e-12) + glm::dvec2(0, 16), fmt::format("{:g}", k * step), SvgAnchor::middle, 11,
                    "#555");
  return out + svg_text({(kLeft + kWidth) / 2, kHeight - 10}, "distance ÷ the light's radius", SvgAnchor::middle);
}

std::string curve(const Axes& a, const Settings& s, size_t which) {
  std::vector<glm::dvec2> points;
  for (int k = 0; k <= kSteps; ++k) {
    const double x = a.far * k / kSteps, value = kStrengths[which] * attenuation_at(s.attenuation, x, 1);
    if (value >= std::pow(10.0, a.low)) points.push_back(a.at(x, value));
  }
  const SvgStroke stroke{"#204a87", 2, kDashes[which]};
  const std::string name = fmt::format("strength {:g}", kStrengths[which]);
  return svg_path(points, false, stroke) +
         svg_text(a.at(0.03 * a.far, kStrengths[which]) + glm::dvec2(6, -6), name, SvgAnchor::start, 12, stroke.colour);
}

// One mark on the threshold's line.
std::string mark(const Axes& a, double x, double threshold, double drop, const std::string& words) {
  const glm::dvec2 at = a.at(x, threshold);
  return svg_line(at, at + glm::dvec2(0, drop), {"#a40000", 1.5}) +
         svg_text(at + glm::dvec2(4, drop), words, x > 0.75 * a.far ? SvgAnchor::end : SvgAnchor::start, 12, "#a40000");
}

}  // namespace

std::string draw_falloff(const Settings& s, const std::string& title) {
  const double threshold = s.range.threshold;
  double solved[2], shortcut[2];
  for (size_t i = 0; i < 2; ++i) {
    solved[i] = range_at_threshold(s.attenuation, kStrengths[i], 1, threshold);
    shortcut[i] = range_by_shortcut(kStrengths[i], 1, threshold);
  }
  const double step = std::pow(10.0, std::floor(std::log10(solved[1] / 2)));
  const Axes axes{1.15 * std::max(solved[1], shortcut[1]), std::floor(std::log10(threshold)) - 1,
                  std::ceil(std::log10(kStrengths[1]))};
  const double labels = axes.far / step > 12 ? 5 * step : step;
  std::string body = svg_text({kLeft, 26}, title, SvgAnchor::start, 16) + grid(axes, labels);
  body += svg_line(axes.at(0, threshold), axes.at(axes.far, threshold), {"#a40000", 1, "2 3"});
  body += svg_text(axes.at(axes.far, threshold) + glm::dvec2(0, -6), fmt::format("threshold {:.4g}", threshold),
                   SvgAnchor::end, 12, "#a40000");
  for (size_t i = 0; i < 2; ++i) {
    body += curve(axes, s, i);
    body += mark(axes, solved[i], threshold, -34, fmt::format("true range {:.1f}", solved[i]));
    body += mark(axes, shortcut[i], threshold, 30,
                 fmt::format("shortcut {:.1f}: {:.0f} %", shortcut[i], 100 * shortcut[i] / solved[i]));
  }
  return svg_page({int(kWidth), int(kHeight)}, body);
}

}  // namespace gbl
