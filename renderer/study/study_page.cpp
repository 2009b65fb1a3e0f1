#include "renderer/study/study_page.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

#include "renderer/base/made_by.h"
#include "renderer/study/row_json.h"
#include "renderer/study/rows/row_words.h"

namespace gbl {
namespace {

// ---- numbers in words -----------------------------------------------------------------------------------------------

std::string unit_of(const StudyColumn& c) { return c.is_share() ? "%" : c.unit; }

std::string number_text(double value, const StudyColumn& c) {
  return fmt::format("{:.4g}", c.is_share() ? 100 * value : value);
}

std::string with_unit(const StudyRow& row, const StudyColumn& c) {
  const std::optional<double> value = column_value(row, c);
  if (!value) return "not measured";
  if (is_noisy(row, c)) return noisy_words(row, c);
  return fmt::format("{}{}{}", number_text(*value, c), unit_of(c).empty() ? "" : " ", unit_of(c));
}

PageCell cell_of(const StudyRow& row, const StudyColumn& c) {
  const std::optional<double> value = column_value(row, c);
  if (!value) return PageCell{"\u2013"};
  return {is_noisy(row, c) ? "noisy" : number_text(*value, c), *value};
}

std::string title_of(const StudyRow& row) {
  const std::string words = row_words(row);
  return words.empty() ? row.name : words;
}

// ---- the table ------------------------------------------------------------------------------------------------------

bool has_value(const std::vector<StudyRow>& rows, const StudyColumn& c) {
  return std::any_of(rows.begin(), rows.end(), [&](const StudyRow& r) { return column_value(r, c).has_value(); });
}

// The chart's two first, then what most readers ask for next.
std::vector<StudyColumn> columns_of(const StudySpec& spec, const std::vector<StudyRow>& rows) {
  std::vector<StudyColumn> out{chart_error_column(spec.y), cost_column(spec.x)};
  const auto add = [&](const StudyColumn& c) {
    const bool known = std::any_of(out.begin(), out.end(), [&](const StudyColumn& o) { return o.id == c.id; });
    if (!known && has_value(rows, c)) out.push_back(c);
  };
  for (const char* id : {"over_1_255_display", "rmse_linear", "max_linear", "flip_mean"}) add(chart_error_column(id));
  for (const char* id : {"time_ms_total_median", "bytes_per_pixel", "pairs_shaded"}) add(cost_column(id));
  return out;
}

PageColumn heading(const StudyColumn& c) {
  const std::string name = c.axis == Axis::cost ? c.label : c.id;  // an error's label explains its id at length
  return {unit_of(c).empty() ? name : fmt::format("{} [{}]", name, unit_of(c)), axis_title(c)};
}

// ---- what is compared side by side ----------------------------------------------------------------------------------

struct Detail {
  std::string name;
  std::function<std::string(const StudyRow&)> text;
};

std::string cell_words(const StudyRow& row, const std::string& column) {
  for (const Cell& c : row.cells) {
    if (c.column != column) continue;
    const auto* n = std::get_if<Number>(&c.value);
    return n && !n->whole && std::isfinite(n->value) ? fmt::format("{:.4g}", n->value) : cell_text(c.value);
  }
  return "";
}

// Settings in which rows differ, then every column.
std::vector<Detail> details_of(const std::vector<StudyRow>& rows) {
  std::vector<Detail> out;
  for (const Option& o : options()) {
    const auto differs = [&](const StudyRow& r) { return o.get(r.settings) != o.get(rows[0].settings); };
    if (o.group != Group::view && std::any_of(rows.begin(), rows.end(), differs))
      out.push_back({o.path, [&o](const StudyRow& r) { return plain(o.get(r.settings)); }});
  }
  std::set<std::string> known;
  for (const StudyRow& row : rows)
    for (const Cell& c : row.cells)
      if (known.insert(c.column).second)
        out.push_back({c.column, [id = c.column](const StudyRow& r) { return cell_words(r, id); }});
  return out;
}

// ---- the chart ------------------------------------------------------------------------------------------------------

std::string words_of(const StudyRow& row, const Chart& chart) {
  const std::string unsound = unsound_words(row.settings);
  return fmt::format("{}\nerror: {} ({})\ncost: {} ({})\n{}", title_of(row), with_unit(row, chart.y), chart.y.id,
                     with_unit(row, chart.x), chart.x.label, unsound.empty() ? "sound" : "\u26a0 unsound: " + unsound);
}

PageChart page_chart(const Chart& chart, const std::vector<StudyRow>& rows) {
  std::vector<double> costs, errors;
  for (const ChartPoint& p : chart.points) costs.push_back(p.cost), errors.push_back(p.error);
  PageChart out{.title = "Cost and error", .x = page_axis(chart.x, costs), .y = page_axis(chart.y, errors)};
  out.families = chart.families;
  out.front = "Pareto front: no other is as good in both";
  for (const ChartPoint& p : chart.points) {
    const auto family = std::find(chart.families.begin(), chart.families.end(), p.family) - chart.families.begin();
    out.points.push_back({.x = p.cost,
                          .y = p.error,
                          .family = static_cast<size_t>(family),
                          .words = words_of(rows[p.row], chart),
                          .row = p.row,
                          .label = p.preset ? p.label : "",
                          .sound = p.sound,
                          .noisy = p.noisy,
                          .marked = p.preset,
                          .on_front = p.on_front});
    if (p.preset) out.marked = "a preset";
  }
  out.note = fmt::format("{} set-ups. {}", chart.points.size(),
                         chart.y.more_is_better ? "Better is to the left and up." : "Better is to the left and down.");
  if (chart.without_value > 0)
    out.note +=
        fmt::format(" {} have no finite value for one of these axes and are in the table only.", chart.without_value);
  const auto noisy = std::count_if(chart.points.begin(), chart.points.end(), [](auto& p) { return p.noisy; });
  if (noisy > 0)
    out.note += fmt::format(
        " {} have a noisy time (crossed out: its run spread by more than {:.0f} %); measure them on a quieter machine.",
        noisy, 100 * kMostSpread);
  if (const std::string mixed = mixed_programs(chart); !mixed.empty()) out.note += fmt::format(" \u26a0 {}.", mixed);
  if (chart.failed > 0) out.note += fmt::format(" {} failed; the table says why.", chart.failed);
  return out;
}

// Rows of several machines are told apart by these columns.
std::string all_values(const std::vector<StudyRow>& rows, const char* column, const std::string& otherwise) {
  std::set<std::string> values;
  for (const StudyRow& r : rows)
    if (!r.text(column).empty()) values.insert(r.text(column));
  return values.empty() ? otherwise : fmt::format("{}", fmt::join(values, "; "));
}

std::string all_programs(const std::vector<StudyRow>& rows) {
  std::set<std::string> values;
  for (const StudyRow& r : rows)
    if (!r.made_by.empty()) values.insert(r.made_by);
  return values.empty() ? made_by() : fmt::format("{}", fmt::join(values, "; "));
}

}  // namespace

Page study_page(const StudySpec& spec, const std::vector<StudyRow>& rows, const Machine& machine,
                const CommandFn& command, const std::filesystem::path& folder) {
  const Chart chart = chart_points(rows, spec.x, spec.y, spec.family);
  Page page{
      .title = spec.label,
      .how_to_read = fmt::format("Each dot is one set-up of the renderer: to the right {}, upwards {}. Its error is "
                                 "measured against a reference in double precision.",
                                 axis_title(chart.x), axis_title(chart.y)),
      .rows_are = "The set-ups",
      .pictures = true};
  page.machine = {{"device", all_values(rows, "device", machine.device)},
                  {"driver", all_values(rows, "driver", machine.driver)},
                  {"times by", all_values(rows, "time_source", "nothing: no row has times")},
                  {"size", all_values(rows, "size", "unknown")},
                  {"gbufferlab", all_programs(rows)},
                  {"study", spec.name}};
  page.charts.push_back(page_chart(chart, rows));
  const std::vector<StudyColumn> columns = columns_of(spec, rows);
  for (const StudyColumn& c : columns) page.columns.push_back(heading(c));
  const std::vector<Detail> details = details_of(rows);
  for (const Detail& d : details) page.details.push_back(d.name);
  for (const StudyRow& row : rows) {
    PageRow out{.words = title_of(row),
                .unsound = unsound_words(row.settings),
                .failed = row.failed.value_or(""),
                .command = command(row.settings),
                .thumbnails = read_thumbnails(folder, row.key)};
    for (const StudyColumn& c : columns) out.cells.push_back(cell_of(row, c));
    for (const Detail& d : details) out.details.push_back(d.text(row));
    page.rows.push_back(std::move(out));
  }
  return page;
}

}  // namespace gbl
