#include "renderer/study/stability/stability_journal.h"

#include <fmt/format.h>

#include "renderer/base/made_by.h"
#include "renderer/study/row_json.h"

namespace gbl {
namespace {

Cell cell(const char* column, const std::optional<double>& value) {
  return {column, value ? ColumnValue(Number(*value)) : ColumnValue()};
}

}  // namespace

std::string point_key(const Sweep& s, const Curve& curve, double value, const Settings& settings) {
  return fmt::format("{}/{}/{}/{}", s.id, curve.id, value, row_key(settings));
}

std::string sweeps_made_by(const Machine& machine, FeatureSet features) {
  std::string text = fmt::format("{} on {}, {}", made_by(), machine.driver, machine.device);
  for (const FeatureRow& f : kFeatures)
    if (!features.has(f.feature)) text += fmt::format(" without {}", f.id);
  return text;
}

StudyRow journal_row(const std::string& key, const SweepRow& point, const Settings& settings,
                     const std::string& made_by) {
  StudyRow row{.study = point.sweep, .name = point.curve, .key = key, .settings = settings, .made_by = made_by};
  row.cells = {cell("x", point.x),
               {"metric", ColumnValue(point.metric)},
               cell("value", point.value),
               cell("lit_pixels", point.lit_pixels)};
  for (const ErrorColumn& c : error_columns()) row.cells.push_back(cell(c.id, point.errors.*c.value));
  return row;
}

SweepRow point_of(const StudyRow& row) {
  SweepRow point{.sweep = row.study,
                 .curve = row.name,
                 .x = row.number("x").value_or(0),
                 .metric = row.text("metric"),
                 .value = row.number("value"),
                 .lit_pixels = row.number("lit_pixels").value_or(0)};
  for (const ErrorColumn& c : error_columns()) point.errors.*c.value = row.number(c.id);
  return point;
}

}  // namespace gbl
