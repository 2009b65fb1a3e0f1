#pragma once
// What is expected of a curve, as data: printed as a sentence, checked against what was measured.
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <variant>

namespace gbl {

// Random configurations instead of a parameter: x is kFamilySpan x family + number, families from 0 (A, B, C).
inline constexpr int kFamilySpan = 1000;

inline constexpr double kNoEnd = std::numeric_limits<double>::infinity();

// One measured point. Empty: nothing was measured. NaN is larger than every bound.
struct CurvePoint {
  double x = 0;
  std::optional<double> value;
};

// At most `most` wherever it was measured.
struct Flat {
  double most = 0;
};

// At most `holds` up to `up_to`, more than `fails` from `from` on. In between nothing is claimed.
struct Diverges {
  double up_to = 0, from = 0;
  double holds = 0, fails = 0;
};

// More than `fails` from `from` to `to`; at most `holds` up to `before` and from `beyond` on. kNoEnd (or -kNoEnd): that
// side does not come back.
struct FailsIn {
  double before = -kNoEnd, from = 0, to = 0, beyond = kNoEnd;
  double holds = 0, fails = 0;
};

// From `from` to `to` a straight line on log-log axes: this slope, `low` to `high` at `at`, and every point within a
// factor `spread` of the line.
struct Grows {
  double slope = 1, tolerance = 0.1;
  double from = -kNoEnd, to = kNoEnd;
  double at = 1, low = 0, high = 0;
  double spread = 2;
};

// Of random configurations from `from` to `to`, this share is above `bound`: exactly none, or about as many as chance
// allows for their number.
struct FailsOften {
  double from = -kNoEnd, to = kNoEnd;
  double bound = 0;
  double share = 0;
};

// From its smallest to its largest value, whatever these are.
struct Wobbles {
  double least = 0, most = kNoEnd;
};

// A valley: the least value lies from `from` to `to` and is at most `most`, and both ends of the curve are above `ends`.
struct Least {
  double from = 0, to = 0;
  double most = 0, ends = 0;
};

using Expected = std::variant<Flat, Diverges, FailsIn, Grows, FailsOften, Wobbles, Least>;

// The words for a curve's axes: "camera's distance", "units"; "lost_pixels", "".
struct AxisWords {
  std::string parameter, parameter_unit, metric, metric_unit;
  bool families = false;  // x is a configuration's number
};
std::string text_of(const Expected&, const AxisWords&);

struct Verdict {
  bool holds = false;
  std::string where;  // where it first does not hold, as a sentence; empty if it does
};

// Points sorted by x. A claim about a stretch in which nothing was measured does not hold.
Verdict check(const Expected&, std::span<const CurvePoint>);

}  // namespace gbl
