#include "renderer/study/stability/stability_journal.h"

#include <fmt/format.h>

#include "renderer/base/made_by.h"

namespace gbl {
namespace {

Cell cell(const char* column, const std::optional<double>& value) {
  return {column, value ? ColumnValue(Number(*value)) : ColumnValue()};
}

}  // namespace

std::string point_key(const Sweep& s, const Curve& curve, double value) {
  return fmt::format("{}/{}/{}", s.id, curve.id, value);
}

std::string sweeps_made_by(const Machine& machine) { return made_by() + " on " + machine.driver; }

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
