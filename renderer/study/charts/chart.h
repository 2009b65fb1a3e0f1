#pragma once
// A study as a chart: every row a point, what it costs to the right, how far it is from the truth upwards. The window
// and the files draw the same points.
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/study/rows/study_row.h"

namespace gbl {

std::string axis_title(const StudyColumn&);  // with the unit; a share in %

struct ChartPoint {
  double cost = 0, error = 0;
  std::string label;   // the preset's id, or the case
  std::string family;  // the value at the family's path
  bool preset = false;
  bool sound = true;   // no choice with a known failure
  bool noisy = false;  // its cost is a time that spreads too far: it is never on the front
  bool on_front = false;
  size_t row = 0;  // of the rows given
};

struct Chart {
  StudyColumn x, y;
  std::vector<ChartPoint> points;     // in the order of the rows
  std::vector<std::string> families;  // in the order of their first points
  size_t without_value = 0;           // rows left out: not measured, or not finite
  size_t failed = 0;                  // rows left out: they could not be drawn
  std::vector<std::string> programs;  // that measured the points (made_by.h), in the order of their first
};
// "measured by 2 versions of the program: A; B", since their numbers are different measurements; "" where there is one.
std::string mixed_programs(const Chart&);
Chart chart_points(const std::vector<StudyRow>& rows, std::string_view x, std::string_view y, std::string_view family);

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
  bool percent = false;           // shares: their ticks are written in %
  double low = 0.1, high = 10;    // a little beyond the values
  double place(double value) const { return zero_at && !(value > 0) ? *zero_at : value; }
  double along(double value) const;  // 0 at the low end, 1 at the high one; what is beyond or not finite: at an end
};
ChartAxis axis_for(const StudyColumn&, const std::vector<double>& values);

struct ChartTick {
  double at;
  std::string label;
};
std::vector<ChartTick> ticks_of(const ChartAxis&);

}  // namespace gbl
