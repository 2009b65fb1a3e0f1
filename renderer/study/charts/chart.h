#pragma once
// A study as a chart: every row a point, what it costs to the right, how far it is from the truth upwards. The window
// and the files draw the same points.
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/json.h"

namespace gbl {

// What can be on an axis: the cost columns, and of the error columns those that say how wrong a picture is.
struct ChartColumn {
  std::string id;
  std::string label;
  std::string unit;                    // "" = a share, a count or a ratio
  bool more_is_better = false;         // a quality; its axis is linear
  bool magnitude = false;              // drawn without its sign
  std::string numerator, denominator;  // of a ratio of two columns; "" = the row has the column itself
};
std::span<const ChartColumn> cost_columns();
std::span<const ChartColumn> chart_error_columns();
// Error(bad_input) with the known ones.
const ChartColumn& cost_column(std::string_view id);
const ChartColumn& chart_error_column(std::string_view id);

std::string axis_title(const ChartColumn&);  // with the unit

// Empty: not measured. Infinities are texts in JSON.
std::optional<double> column_value(const Json& row, const ChartColumn&);

struct ChartPoint {
  double cost = 0, error = 0;
  std::string label;   // the preset's id, or the case
  std::string family;  // the value at the family's path
  bool preset = false;
  bool on_front = false;
  size_t row = 0;  // of the rows given
};

struct Chart {
  ChartColumn x, y;
  std::vector<ChartPoint> points;     // in the order of the rows
  std::vector<std::string> families;  // in the order of their first points
  size_t without_value = 0;           // rows left out: not measured, or not finite
  size_t failed = 0;                  // rows left out: they could not be drawn
};
Chart chart_points(const std::vector<Json>& rows, std::string_view x, std::string_view y, std::string_view family);

// Which points no other beats: none is as good in both and better in one. Equal points are on it together.
struct CostError {
  double cost, error;  // less is better
};
std::vector<bool> pareto_front(std::span<const CostError>);

// How an axis shows its values. On a logarithmic one 0 has no place: it is drawn at `zero_at`, a decade below the
// smallest value above 0, and the axis says "0" there.
struct ChartAxis {
  bool logarithmic = true;
  std::optional<double> zero_at;  // there are zeros
  double low = 0.1, high = 10;    // a little beyond the values
  double place(double value) const { return zero_at && !(value > 0) ? *zero_at : value; }
};
ChartAxis axis_for(const ChartColumn&, const std::vector<double>& values);

struct ChartTick {
  double at;
  std::string label;
};
std::vector<ChartTick> ticks_of(const ChartAxis&);

}  // namespace gbl
