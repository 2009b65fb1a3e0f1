#include "renderer/inspect/view_legends.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/gbuffer/layouts.h"
#include "renderer/inspect/view_stats.h"
#include "renderer/light/light_methods.h"

namespace gbl {
namespace {

glm::vec3 grey(double g) { return glm::vec3(static_cast<float>(g)); }

constexpr int kBarSteps = 4;

}  // namespace

double round_for_bar(double x) {
  const double decade = std::pow(10, std::floor(std::log10(x)));
  for (const double step : {1.0, 1.2, 1.6, 2.0, 2.4, 3.2, 4.0, 6.0, 8.0})
    if (step * decade >= x) return step * decade;
  return 10 * decade;
}

double position_cycle(const Bounds& bounds) {
  const double extent = std::max(1e-9, glm::length(bounds.extent()));
  return std::pow(10.0, std::floor(std::log10(extent / 10)));
}

glm::dvec2 depth_view_range(const Camera& camera, const Bounds& bounds) {
  double farthest = camera.near;  // a scene behind the camera still needs a bar
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p(corner & 1 ? bounds.max.x : bounds.min.x, corner & 2 ? bounds.max.y : bounds.min.y,
                       corner & 4 ? bounds.max.z : bounds.min.z);
    farthest = std::max(farthest, glm::dot(p - camera.position, camera.forward()));
  }
  return {0, std::min(round_for_bar(farthest), camera.far)};
}

Legend fitted_legend(const LegendOf& of) {
  Legend bar{true, {}, {}};
  for (int i = 0; i <= kBarSteps; ++i) {
    const double t = static_cast<double>(i) / kBarSteps;
    bar.entries.push_back({fmt::format("{:.6g}", glm::mix(of.range.x, of.range.y, t)), grey(t)});
  }
  return bar;
}

Legend look_legend(const LegendOf& of, const ViewLook& look, bool single_number) {
  if (!single_number)
    return {false,
            {{fmt::format("black {:.4g}", of.range.x), glm::vec3(0)},
             {fmt::format("white {:.4g}", of.range.y), glm::vec3(1)}},
            {}};
  constexpr int kFiner = 4;  // colours between two numbers
  const auto stops = stops_of(look.map == ColourMap::own ? ColourMap::grey : look.map);
  Legend bar{true, {}, {}};
  for (int i = 0; i <= kBarSteps * kFiner; ++i) {
    const double t = static_cast<double>(i) / (kBarSteps * kFiner);
    const bool numbered = i % kFiner == 0;
    bar.entries.push_back(
        {numbered ? fmt::format("{:.5g}", glm::mix(of.range.x, of.range.y, t)) : "", colour_at(stops, t)});
  }
  return bar;
}

Legend depth_legend(const LegendOf& of) {
  Legend bar = fitted_legend(of);
  bar.entries.back().label += " units";
  bar.apart = {{"sky", kSkyColour}};
  return bar;
}

Legend material_legend(const LegendOf& of) {
  const Settings& s = of.settings;
  if (layout_of(s).shows == MaterialView::specular && shading_of(s.lights.method) == Shading::deferred)
    return {false, {{"colour of the highlight", grey(0.5)}}, {}};
  Legend bar{true, {}, {}};
  for (int i = 0; i <= kBarSteps; ++i) {
    const double roughness = static_cast<double>(i) / kBarSteps;
    std::string label = fmt::format("{:g}", roughness);
    if (s.shading.exponent == kExponentFromRoughness) {
      const double exponent = std::clamp(2 / std::pow(roughness, 4) - 2, 1.0, 8192.0);
      label += fmt::format(" ({}{:.0f})", i == 0 ? "exponent " : "", exponent);
    }
    bar.entries.push_back({label, grey(roughness)});
  }
  return bar;
}

Legend normal_legend(const LegendOf&) {
  Legend axes;
  for (const float sign : {1.0f, -1.0f})
    for (int k = 0; k < 3; ++k) {
      glm::vec3 n(0);
      n[k] = sign;
      axes.entries.push_back({fmt::format("{}{}", sign > 0 ? '+' : '-', "XYZ"[k]), n * 0.5f + 0.5f});
    }
  return axes;
}

CountSteps count_steps(const ViewStats* stats) {
  constexpr int kPlain = kLightCountColours - 1;
  int last = kPlain;
  constexpr double kMost = 1e8;  // more lights than there can be; distances and positions come here as well
  const double largest = stats ? std::min(stats->largest(), kMost) : 0;
  for (int decade = 10; decade <= largest; decade *= 10)
    for (const int times : {1, 2, 5})
      if (times * decade <= largest) last = times * decade;
  CountSteps from{};
  for (int i = 1; i <= kPlain; ++i)
    from[static_cast<size_t>(i)] =
        last == kPlain ? i : std::max(i, static_cast<int>(std::lround(std::pow(last, (i - 1) / double(kPlain - 1)))));
  return from;
}

Legend count_legend(const LegendOf& of) {
  const CountSteps from = count_steps(of.stats);
  Legend counts;
  for (size_t i = 0; i < from.size(); ++i) {
    const bool last = i + 1 == from.size();
    const int to = last ? from[i] : from[i + 1] - 1;
    counts.entries.push_back({last            ? fmt::format("{}+", from[i])
                              : to == from[i] ? fmt::format("{}", to)
                                              : fmt::format("{}-{}", from[i], to),
                              kLightCountPalette[i]});
  }
  return counts;
}

Legend class_legend(std::span<const ViewClass> classes) {
  Legend out;
  for (const ViewClass& c : classes) out.entries.push_back({c.label, c.colour});
  return out;
}

Legend position_legend(const LegendOf& of) {
  return {false,
          {{"red: x", {1, 0, 0}},
           {"green: y", {0, 1, 0}},
           {"blue: z", {0, 0, 1}},
           {fmt::format("one colour cycle = {:g} units", position_cycle(of.bounds)), grey(0.5)}},
          {}};
}

}  // namespace gbl
