#include "renderer/study/charts/chart.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numeric>

#include "renderer/base/error.h"
#include "renderer/truth/measure.h"

namespace gbl {
namespace {

std::vector<ChartColumn> make_error_columns() {
  std::vector<ChartColumn> list;
  for (const ErrorColumn& e : error_columns()) {
    const std::string_view id = e.id;
    if (id == "compared_pixels") continue;  // says how many were judged, not how
    list.push_back({.id = e.id,
                    .label = fmt::format("{}: {}", e.id, e.help),
                    .unit = e.unit,
                    .more_is_better = id == "psnr_display",
                    .magnitude = id == "signed_mean_linear"});
  }
  return list;
}

const ChartColumn& column_of(std::span<const ChartColumn> columns, std::string_view id, std::string_view what) {
  std::vector<std::string_view> known;
  for (const ChartColumn& c : columns) {
    if (c.id == id) return c;
    known.emplace_back(c.id);
  }
  throw Error(ExitCode::bad_input, what, fmt::format("unknown column '{}'", id), suggest(id, known));
}

std::optional<double> number(const Json& row, const std::string& id) {
  const auto it = row.find(id);
  if (it == row.end()) return {};
  if (it->is_number()) return it->get<double>();
  if (*it == "inf") return std::numeric_limits<double>::infinity();
  if (*it == "-inf") return -std::numeric_limits<double>::infinity();
  return {};
}

const Json* member(const Json& node, std::string_view name) {
  if (!node.is_object()) return nullptr;
  const auto it = node.find(std::string(name));
  return it == node.end() ? nullptr : &*it;
}

// As asked for in the case, or else as drawn: "auto" stays a family of its own.
std::string family_of(const Json& row, std::string_view path) {
  const auto text = [](const Json& v) { return v.is_string() ? v.get<std::string>() : v.dump(); };
  if (const Json* at = member(row, "at"))
    if (const Json* value = member(*at, path)) return text(*value);
  const Json* node = member(row, "settings");
  while (node && !path.empty()) {
    const size_t dot = std::min(path.find('.'), path.size());
    node = member(*node, path.substr(0, dot));
    path.remove_prefix(std::min(dot + 1, path.size()));
  }
  return node ? text(*node) : "";
}

ChartPoint point_of(const Json& row, size_t index, double cost, double error, std::string_view family) {
  ChartPoint p{.cost = cost, .error = error, .family = family_of(row, family), .row = index};
  const Json* at = member(row, "at");
  const Json* preset = at ? member(*at, "preset") : nullptr;
  const Json* label = preset ? preset : member(row, "case");
  p.preset = preset != nullptr;
  if (label && label->is_string()) p.label = label->get<std::string>();
  return p;
}

void mark_front(Chart& chart) {
  std::vector<CostError> places;
  for (const ChartPoint& p : chart.points) places.push_back({p.cost, chart.y.more_is_better ? -p.error : p.error});
  const std::vector<bool> front = pareto_front(places);
  for (size_t i = 0; i < front.size(); ++i) chart.points[i].on_front = front[i];
}

}  // namespace

std::span<const ChartColumn> cost_columns() {
  static const ChartColumn kColumns[] = {
      {.id = "time_ms_total_median", .label = "time of a frame, median", .unit = "ms"},
      {.id = "time_ms_lighting_median", .label = "time of the lighting, median", .unit = "ms"},
      {.id = "bytes_per_pixel", .label = "G-buffer", .unit = "bytes per pixel"},
      {.id = "accumulation_bytes_per_pixel", .label = "light targets", .unit = "bytes per pixel"},
      {.id = "mib", .label = "all targets of a frame", .unit = "MiB"},
      {.id = "pairs_shaded", .label = "pairs of pixel and light shaded", .unit = ""},
      {.id = "pairs_tested", .label = "pairs of pixel and light tested", .unit = ""},
      {.id = "shaded_per_lit",
       .label = "pairs shaded for each one that is lit",
       .numerator = "pairs_shaded",
       .denominator = "pairs_lit"},
      {.id = "draw_calls", .label = "draw calls", .unit = ""},
  };
  return kColumns;
}

std::span<const ChartColumn> chart_error_columns() {
  static const std::vector<ChartColumn> kColumns = make_error_columns();
  return kColumns;
}

const ChartColumn& cost_column(std::string_view id) { return column_of(cost_columns(), id, "x"); }
const ChartColumn& chart_error_column(std::string_view id) { return column_of(chart_error_columns(), id, "y"); }

std::string axis_title(const ChartColumn& c) {
  return c.unit.empty() ? c.label : fmt::format("{} [{}]", c.label, c.unit);
}

std::optional<double> column_value(const Json& row, const ChartColumn& c) {
  if (c.numerator.empty()) {
    const auto value = number(row, c.id);
    return value && c.magnitude ? std::abs(*value) : value;
  }
  const auto over = number(row, c.numerator), under = number(row, c.denominator);
  if (!over || !under || *under == 0) return {};
  return *over / *under;
}

Chart chart_points(const std::vector<Json>& rows, std::string_view x, std::string_view y, std::string_view family) {
  Chart chart{cost_column(x), chart_error_column(y), {}, {}};
  for (size_t i = 0; i < rows.size(); ++i) {
    const auto cost = column_value(rows[i], chart.x), error = column_value(rows[i], chart.y);
    if (rows[i].contains("failed"))
      ++chart.failed;
    else if (!cost || !error || !std::isfinite(*cost) || !std::isfinite(*error))
      ++chart.without_value;
    else
      chart.points.push_back(point_of(rows[i], i, *cost, *error, family));
  }
  for (const ChartPoint& p : chart.points)
    if (std::find(chart.families.begin(), chart.families.end(), p.family) == chart.families.end())
      chart.families.push_back(p.family);
  mark_front(chart);
  return chart;
}

std::vector<bool> pareto_front(std::span<const CostError> points) {
  std::vector<size_t> order(points.size());
  std::iota(order.begin(), order.end(), size_t(0));
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return points[a].cost != points[b].cost ? points[a].cost < points[b].cost : points[a].error < points[b].error;
  });
  std::vector<bool> front(points.size(), false);
  const CostError* last = nullptr;  // the front's latest: no cheaper point has less error
  for (const size_t i : order) {
    const CostError& p = points[i];
    const bool tie = last && p.cost == last->cost && p.error == last->error;
    if (last && !tie && p.error >= last->error) continue;
    front[i] = true;
    last = &p;
  }
  return front;
}

}  // namespace gbl
