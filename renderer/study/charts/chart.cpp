#include "renderer/study/charts/chart.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numeric>

namespace gbl {
namespace {

const OptionValue* at_path(const StudyRow& row, std::string_view path) {
  for (const Assignment& a : row.at)
    if (a.path == path) return &a.value;
  return nullptr;
}

// As asked for in the case, or else as drawn: "auto" stays a family of its own. A preset is no setting: "" without one.
std::string family_of(const StudyRow& row, std::string_view path) {
  if (const OptionValue* value = at_path(row, path)) return plain(*value);
  for (const Option& o : options())
    if (o.path == path) return plain(o.get(row.settings));
  return "";
}

ChartPoint point_of(const StudyRow& row, size_t index, double cost, double error, bool noisy, std::string_view family) {
  const OptionValue* preset = at_path(row, "preset");
  return {.cost = cost,
          .error = error,
          .label = preset ? plain(*preset) : row.name,
          .family = family_of(row, family),
          .preset = preset != nullptr,
          .sound = sound(row.settings),
          .noisy = noisy,
          .row = index};
}

void mark_front(Chart& chart) {
  std::vector<ChartPoint*> judged;
  std::vector<CostError> places;
  for (ChartPoint& p : chart.points) {
    if (p.noisy) continue;
    judged.push_back(&p);
    places.push_back({p.cost, chart.y.more_is_better ? -p.error : p.error});
  }
  const std::vector<bool> front = pareto_front(places);
  for (size_t i = 0; i < front.size(); ++i) judged[i]->on_front = front[i];
}

}  // namespace

std::string axis_title(const StudyColumn& c) {
  const std::string unit = c.is_share() ? "%" : c.unit;
  return unit.empty() ? c.label : fmt::format("{} [{}]", c.label, unit);
}

Chart chart_points(const std::vector<StudyRow>& rows, std::string_view x, std::string_view y, std::string_view family) {
  Chart chart{cost_column(x), chart_error_column(y), {}, {}};
  for (size_t i = 0; i < rows.size(); ++i) {
    const auto cost = column_value(rows[i], chart.x), error = column_value(rows[i], chart.y);
    if (rows[i].failed)
      ++chart.failed;
    else if (!cost || !error || !std::isfinite(*cost) || !std::isfinite(*error))
      ++chart.without_value;
    else
      chart.points.push_back(point_of(rows[i], i, *cost, *error, is_noisy(rows[i], chart.x), family));
  }
  for (const ChartPoint& p : chart.points) {
    const std::string& by = rows[p.row].made_by;
    if (!by.empty() && std::find(chart.programs.begin(), chart.programs.end(), by) == chart.programs.end())
      chart.programs.push_back(by);
  }
  for (const ChartPoint& p : chart.points)
    if (std::find(chart.families.begin(), chart.families.end(), p.family) == chart.families.end())
      chart.families.push_back(p.family);
  mark_front(chart);
  return chart;
}

std::string mixed_programs(const Chart& chart) {
  if (chart.programs.size() < 2) return "";
  return fmt::format("measured by {} versions of the program: {}", chart.programs.size(),
                     fmt::join(chart.programs, "; "));
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
