#include "renderer/study/stability/stability_page.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/base/made_by.h"
#include "renderer/study/rows/row_words.h"
#include "renderer/study/stability/stability_chart_parts.h"

namespace gbl {

using stability::is_share;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string with_unit(double value, const std::string& unit) {
  return fmt::format("{:.4g}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string value_words(const std::optional<double>& value, const SweepMetric& m) {
  if (!value) return "not measured";
  if (!std::isfinite(*value)) return "not finite";
  return is_share(m) ? fmt::format("{:.4g} %", 100 * *value) : with_unit(*value, m.unit);
}

StudyColumn parameter_column(const Sweep& s) {
  return {.unit = s.unit, .label = s.parameter, .more_is_better = !s.log_axis};
}
StudyColumn metric_column(const SweepMetric& m) {
  return {.unit = m.unit, .label = fmt::format("{}: {}", m.id, m.help), .share_of = is_share(m) ? "pixels" : ""};
}

// ---- charts ---------------------------------------------------------------------------------------------------------

PageChart chart_of(const SweepResult& result, size_t first_row) {
  const Sweep& s = *result.sweep;
  const SweepMetric& metric = sweep_metric(s.metric);
  PageChart chart{.title = s.label,
                  .note = result.given.empty() ? fmt::format("{}: {}.", s.id, s.help)
                                               : fmt::format("{}, measured with {}.", s.id, result.given),
                  .joined = true};
  std::vector<double> xs, finite;
  for (size_t i = 0; i < result.curves.size(); ++i) {
    const CurveResult& c = result.curves[i];
    chart.families.push_back(c.curve);
    for (const SweepRow& r : c.rows) {
      if (!r.value) continue;
      xs.push_back(r.x);
      if (std::isfinite(*r.value)) finite.push_back(*r.value);
      chart.points.push_back({.x = r.x,
                              .y = std::isfinite(*r.value) ? *r.value : kInfinity,
                              .family = i,
                              .words = fmt::format("{}\n{}: {}\n{}: {}", c.curve, s.parameter, with_unit(r.x, s.unit),
                                                   metric.id, value_words(r.value, metric)),
                              .row = first_row + i,
                              .sound = sound(c.settings)});
    }
  }
  chart.x = page_axis(parameter_column(s), xs), chart.y = page_axis(metric_column(metric), finite);
  if (finite.size() < xs.size()) chart.note += " At the upper edge: not finite.";
  return chart;
}

// ---- the table ------------------------------------------------------------------------------------------------------

std::string statements(const CurveResult& c) {
  std::string text;
  for (const Judged& j : c.judged)
    text +=
        fmt::format("{}{}{}", text.empty() ? "" : "; ", j.statement, j.verdict.holds ? "" : ". But " + j.verdict.where);
  return text;
}

std::string family_words(const CurveResult& c) {
  std::string text;
  for (int family = 0; family < kFamilies; ++family) {
    const FamilyShares s = family_shares(c, family);
    text +=
        fmt::format("; family {}: {:.0f} % of {} configurations wrong", "ABC"[family], 100 * s.wrong, s.configurations);
  }
  return text;
}

const char* verdict(const CurveResult& c) {
  if (c.judged.empty()) return "not judged";
  const bool holds = std::all_of(c.judged.begin(), c.judged.end(), [](const Judged& j) { return j.verdict.holds; });
  return holds ? "holds" : "DOES NOT HOLD";
}

struct Ends {
  std::optional<double> least, most;
};
Ends ends_of(const CurveResult& c) {
  Ends e;
  for (const SweepRow& r : c.rows) {
    if (!r.value) continue;
    const double v = std::isnan(*r.value) ? kInfinity : *r.value;
    e.least = std::min(e.least.value_or(v), v), e.most = std::max(e.most.value_or(v), v);
  }
  return e;
}

PageCell cell_of(const std::optional<double>& value, const SweepMetric& m) {
  PageCell cell{value_words(value, m)};
  if (value && std::isfinite(*value)) cell.number = value;
  return cell;
}

PageRow row_of(const SweepResult& result, const CurveResult& c) {
  const SweepMetric& metric = sweep_metric(result.sweep->metric);
  const Ends ends = ends_of(c);
  const std::string stated = statements(c) + (has_families(*result.sweep) ? family_words(c) : "");
  PageRow row{.words = fmt::format("{}: {}", result.sweep->id, c.curve),
              .unsound = unsound_words(c.settings),
              .failed = c.not_drawn,
              .command = fmt::format("gbufferlab stability {}{}{}", result.sweep->id, result.given.empty() ? "" : " ",
                                     result.given)};
  row.cells = {{metric.id}, cell_of(ends.least, metric), cell_of(ends.most, metric), {verdict(c)}, {stated}};
  row.details = {metric.id,
                 std::to_string(c.rows.size()),
                 value_words(ends.least, metric),
                 value_words(ends.most, metric),
                 verdict(c),
                 stated};
  return row;
}

}  // namespace

Page stability_page(const std::vector<SweepResult>& results, const Machine& machine,
                    const std::string& rounding_words) {
  Page page{.title = "Where each method fails",
            .how_to_read =
                "One parameter is moved, to the right, through the place where methods break; the error of each is "
                "upwards. Of every curve something is stated, and checked against a reference in double precision.",
            .rows_are = "The curves"};
  page.machine = {
      {"device", machine.device}, {"driver", machine.driver}, {"rounding", rounding_words}, {"gbufferlab", made_by()}};
  page.columns = {{"metric"}, {"smallest"}, {"largest"}, {"verdict"}, {"what is stated"}};
  page.details = {"metric", "points", "smallest", "largest", "verdict", "what is stated"};
  page.commands_are = "The command measures that row's sweep again.";
  for (const SweepResult& result : results) {
    const bool has_points =
        std::any_of(result.curves.begin(), result.curves.end(), [](const CurveResult& c) { return !c.rows.empty(); });
    if (has_points && !has_families(*result.sweep)) page.charts.push_back(chart_of(result, page.rows.size()));
    for (const CurveResult& c : result.curves) page.rows.push_back(row_of(result, c));
  }
  return page;
}

}  // namespace gbl
