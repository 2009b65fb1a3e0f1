// Rows of the chart in words.
#include <cmath>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/options/settings_json.h"
#include "ui/chart_view.h"

namespace gbl::ui {
namespace {

const Option* option_or_null(std::string_view path) {
  for (const Option& o : options())
    if (o.path == path) return &o;
  return nullptr;
}

std::string plain_text(const Json& v) { return v.is_string() ? v.get<std::string>() : v.dump(); }

// "Method: Tiled, 16x16 px", as the control column calls it.
std::string coordinate_text(const std::string& path, const Json& value) {
  const Option* o = option_or_null(path);
  if (!o)
    return fmt::format("{}: {}", path == "lights" ? "Lights" : path == "preset" ? "Preset" : path, plain_text(value));
  if (o->kind == Kind::choice)
    for (const ValueRow& r : o->values)
      if (value == r.id) return fmt::format("{}: {}", o->label, r.label);
  return fmt::format("{}: {}", o->label, plain_text(value));
}

std::optional<double> number(const Json& row, const std::string& id) {
  const auto it = row.find(id);
  return it != row.end() && it->is_number() ? std::optional(it->get<double>()) : std::nullopt;
}

std::string with_unit(double value, const ChartColumn& c) {
  return fmt::format("{:.4g}{}{}", value, c.unit.empty() ? "" : " ", c.unit);
}

std::string value_of(const Json& row, const ChartColumn& c) {
  const std::optional<double> value = column_value(row, c);
  if (!value) return "not measured";
  std::string text = with_unit(*value, c);
  constexpr std::string_view kMedian = "_median";
  if (!c.id.ends_with(kMedian)) return text;
  const std::string stem = c.id.substr(0, c.id.size() - kMedian.size());
  const auto p10 = number(row, stem + "_p10"), p90 = number(row, stem + "_p90");
  if (p10 && p90) text += fmt::format(" (p10 {:.4g}, p90 {:.4g})", *p10, *p90);
  return text;
}

std::string pairs_text(const Json& row) {
  const auto shaded = number(row, "pairs_shaded"), lit = number(row, "pairs_lit");
  if (!shaded) return "not counted";
  std::string text = fmt::format("{} shaded", grouped(static_cast<uint64_t>(*shaded)));
  if (lit) text += fmt::format(", {} lit", grouped(static_cast<uint64_t>(*lit)));
  return text;
}

std::string bytes_text(const Json& row) {
  return fmt::format("{:.4g} B G-buffer + {:.4g} B light a pixel", number(row, "bytes_per_pixel").value_or(0),
                     number(row, "accumulation_bytes_per_pixel").value_or(0));
}

// A share of the pixels says more as a number of them.
std::string error_text(const Json& row, const ChartColumn& c) {
  const std::optional<double> share = column_value(row, c), all = number(row, "compared_pixels");
  if (!c.id.starts_with("over_") || !share || !all || !std::isfinite(*share)) return value_of(row, c);
  return fmt::format("{} of {} pixels ({:.4g})", grouped(static_cast<uint64_t>(std::lround(*share * *all))),
                     grouped(static_cast<uint64_t>(*all)), *share);
}

Field sound_field(const Settings& s) {
  std::set<std::string> pitfalls;  // two choices may share one
  for (const Unsound& u : unsound_choices(s)) pitfalls.insert(u.pitfall);
  const std::string text = fmt::format("{}", fmt::join(pitfalls, ", "));
  if (text.empty()) return {"sound", "yes", kText};
  return {"sound", fmt::format("{} unsound: {}", kUnsoundSign, text), kUnsound};
}

}  // namespace

std::string row_title(const ChartInput& in, size_t index) {
  std::string text;
  const auto add = [&](const std::string& words) { text += (text.empty() ? "" : " · ") + words; };
  const Json& row = in.rows[index];
  const auto at = row.find("at");
  if (at != row.end() && at->is_object())
    for (const auto& [path, value] : at->items()) add(coordinate_text(path, value));
  if (!text.empty() || index >= in.settings.size()) return text;
  for (const FamilyPath& family : family_paths()) {  // tried by hand: no study says in what it differs
    const Option& o = option(family.path);
    add(coordinate_text(o.path, to_json(o.get(in.settings[index]))));
  }
  return text;
}

std::vector<Field> row_fields(const ChartInput& in, const ChartView& v, size_t index) {
  const Json& row = in.rows[index];
  if (row.contains("failed")) return {{"failed", plain_text(row["failed"]), kUnsound}};
  std::vector<Field> fields{{"error", error_text(row, v.chart.y), kText},
                            {"cost", value_of(row, v.chart.x), kText},
                            {"stored", bytes_text(row), kText},
                            {"pairs", pairs_text(row), kText}};
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
  if (v.chart.failed > 0) text += fmt::format(", {} failed", v.chart.failed);
  if (in.measuring) text += "; measuring the settings at hand …";
  return text;
}

}  // namespace gbl::ui
