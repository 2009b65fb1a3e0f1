// Rows of the chart in words.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/study/rows/row_words.h"
#include "ui/panels/chart_view.h"

namespace gbl::ui {
namespace {

std::string with_unit(double value, const StudyColumn& c) {
  return fmt::format("{:.4g}{}{}", value, c.unit.empty() ? "" : " ", c.unit);
}

std::string value_of(const StudyRow& row, const StudyColumn& c) {
  const std::optional<double> value = column_value(row, c);
  if (!value) return "not measured";
  if (is_noisy(row, c)) return noisy_words(row, c);
  std::string text = with_unit(*value, c);
  const auto p10 = row.number(c.p10), p90 = row.number(c.p90);
  if (p10 && p90) text += fmt::format(" (p10 {:.4g}, p90 {:.4g})", *p10, *p90);
  return text;
}

std::string pairs_text(const StudyRow& row) {
  const auto shaded = row.number("pairs_shaded"), lit = row.number("pairs_lit");
  if (!shaded) return "not counted";
  std::string text = fmt::format("{} shaded", grouped(static_cast<uint64_t>(*shaded)));
  if (lit) text += fmt::format(", {} lit", grouped(static_cast<uint64_t>(*lit)));
  return text;
}

std::string bytes_text(const StudyRow& row) {
  return fmt::format("{:.4g} B G-buffer + {:.4g} B light a pixel", row.number("bytes_per_pixel").value_or(0),
                     row.number("accumulation_bytes_per_pixel").value_or(0));
}

// A share of the pixels says more as a number of them.
std::string error_text(const StudyRow& row, const StudyColumn& c) {
  const std::optional<double> share = column_value(row, c), all = row.number(c.share_of);
  if (!share || !all || !std::isfinite(*share)) return value_of(row, c);
  return fmt::format("{} of {} pixels ({:.4g})", grouped(static_cast<uint64_t>(std::lround(*share * *all))),
                     grouped(static_cast<uint64_t>(*all)), *share);
}

Field sound_field(const Settings& s) {
  const std::string text = unsound_words(s);
  if (text.empty()) return {"sound", "yes", theme().text};
  return {"sound", fmt::format("{} unsound: {}", kUnsoundSign, text), theme().unsound};
}

}  // namespace

std::string row_title(const ChartInput& in, size_t index) {
  std::string text = row_words(in.rows[index]);
  const auto add = [&](const std::string& words) { text += (text.empty() ? "" : " · ") + words; };
  if (!text.empty() || index >= in.settings.size()) return text;
  for (const FamilyPath& family : family_paths()) {  // tried by hand: no study says in what it differs
    const Option& o = option(family.path);
    add(coordinate_words(o.path, o.get(in.settings[index])));
  }
  return text;
}

std::vector<Field> row_fields(const ChartInput& in, const ChartView& v, size_t index) {
  const StudyRow& row = in.rows[index];
  if (row.failed) return {{"failed", *row.failed, theme().unsound}};
  std::vector<Field> fields{{"error", error_text(row, v.chart.y), theme().text},
                            {"cost", value_of(row, v.chart.x), theme().text},
                            {"stored", bytes_text(row), theme().text},
                            {"pairs", pairs_text(row), theme().text}};
  if (index < in.settings.size()) fields.push_back(sound_field(in.settings[index]));
  return fields;
}

std::string progress_text(const ChartInput& in) {
  if (in.total == 0) return "";
  std::string text = fmt::format("{}/{}", in.done, in.total);
  if (in.running.empty()) return text;
  if (!in.seconds_left) return text + ", running";
  const long s = std::lround(*in.seconds_left);
  return text + (s >= 120 ? fmt::format(", {} min left", (s + 30) / 60) : fmt::format(", {} s left", s));
}

std::string counts_text(const ChartInput& in, const ChartView& v) {
  std::string text = fmt::format("{} point{}", v.shown.size(), v.shown.size() == 1 ? "" : "s");
  const size_t off = v.chart.points.size() - v.shown.size();
  size_t outside = 0;
  const PlotAxis x{v.x}, y{v.y};
  for (const size_t i : v.shown) outside += !x.shows(v.point(i).cost) || !y.shows(v.point(i).error);
  if (outside > 0) text += fmt::format(", {} outside this zoom (0 shows all)", outside);
  if (off > 0) text += fmt::format(", {} of families that are off", off);
  if (v.chart.without_value > 0) text += fmt::format(", {} without a value on these axes", v.chart.without_value);
  const auto noisy = std::count_if(v.shown.begin(), v.shown.end(), [&](size_t i) { return v.point(i).noisy; });
  if (noisy > 0) text += fmt::format(", {} with a noisy time (crossed out)", noisy);
  if (v.chart.programs.size() > 1) text += fmt::format(", of {} versions of the program", v.chart.programs.size());
  if (v.chart.failed > 0) text += fmt::format(", {} failed", v.chart.failed);
  if (in.measuring) text += "; measuring the settings at hand …";
  return text;
}

std::string chart_in_words(const FrameContext& f) {
  const ChartInput& in = chart_input(f);
  const ChartView v = chart_view(f);
  std::string text = fmt::format("{} {}, {}.", f.state.of<ChartState>().study, progress_text(in), counts_text(in, v));
  const std::optional<size_t> at = v.selected ? v.selected : v.current;
  if (!at) return text;
  const size_t row = v.point(*at).row;
  text += fmt::format(" {}: {}", v.selected ? "Chosen" : "Now", row_title(in, row));
  for (const Field& field : row_fields(in, v, row)) text += fmt::format(", {} {}", field.label, field.text);
  return text + ".";
}

}  // namespace gbl::ui
