#pragma once
// The columns by which set-ups are compared, one row each. Files, `bench`, the chart's axes and its words follow from
// them: a new column is one row and what measures it.
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "renderer/frame/frame_report.h"
#include "renderer/options/option_value.h"
#include "renderer/truth/measure.h"

namespace gbl {

// Times of repeated frames of one pass, milliseconds.
struct TimeSpread {
  double median = 0, p10 = 0, p90 = 0;
};
// A time whose run spreads by more than this share of its median says what else the machine did: it is shown as noisy.
inline constexpr double kMostSpread = 0.3;
inline bool noisy(const TimeSpread& t) { return t.p90 - t.p10 > kMostSpread * t.median; }
// Nearest-rank percentiles; the list must not be empty.
TimeSpread spread_of(std::vector<double> ms);

struct Timing {
  std::map<std::string, std::vector<double>> pass_ms;  // by pass, one number per frame
  int frames = 0;
};

struct Machine {
  std::string driver, device;
};

struct Measurement {
  const FrameReport& report;
  const Errors& errors;
  const Timing& timing;
  const Machine& machine;
};

// Empty: not measured. A number that is whole is a count, and is written as one.
using ColumnValue = std::variant<std::monostate, Number, std::string>;

struct Cell {
  std::string column;
  ColumnValue value;
  bool operator==(const Cell&) const = default;
};

enum class Axis { none, cost, error };

struct StudyColumn {
  std::string id;
  std::string unit;                              // "" = a share, a count or a ratio
  std::string label;                             // in words, of an axis
  Axis axis = Axis::none;                        // on which it can be
  int place = 0;                                 // among the costs to choose from
  bool more_is_better = false;                   // a quality; its axis is linear
  bool magnitude = false;                        // drawn without its sign
  std::string share_of = {};                     // a share of the count in this column; "" = none
  std::string p10 = {}, p90 = {};                // the columns with its spread; "" = none
  std::string numerator = {}, denominator = {};  // a ratio of two columns, in charts only; "" = it is measured
  std::function<ColumnValue(const Measurement&)> of_row = {};             // in the rows of studies
  ColumnValue (*of_frame)(const FrameReport&, const Machine&) = nullptr;  // in these and in the report of a frame
  bool is_share() const { return !share_of.empty(); }
};
std::span<const StudyColumn> study_columns();  // in the order of files

// All columns of a row, those of the times by pass among them: "time_ms_PASS_median", "_p10", "_p90".
std::vector<Cell> cells_of(const Measurement&);
// What one frame costs but for its times.
std::vector<Cell> cells_of(const FrameReport&, const Machine&);

std::span<const StudyColumn> cost_columns();         // for an axis, by their places
std::span<const StudyColumn> chart_error_columns();  // for an axis: those that say how wrong a picture is
// Error(bad_input) with the known ones.
const StudyColumn& cost_column(std::string_view id);
const StudyColumn& chart_error_column(std::string_view id);

}  // namespace gbl
