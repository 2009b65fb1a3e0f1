#include "renderer/study/stability/stability_statement.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace gbl {
namespace {

std::string quantity(double value, const std::string& unit) {
  return unit.empty() ? fmt::format("{:.4g}", value) : fmt::format("{:.4g} {}", value, unit);
}

struct Writer {
  const AxisWords& words;
  std::string y(double value) const { return quantity(value, words.metric_unit); }
  std::string x(double value) const { return quantity(value, words.parameter_unit); }

  // "from a to b", without the end that is none
  std::string stretch(double from, double to) const {
    if (std::isinf(from) && std::isinf(to)) return "everywhere";
    if (std::isinf(from)) return "up to " + x(to);
    if (from == to) return "at " + x(to);
    if (std::isinf(to)) return "from " + x(from) + " on";
    return fmt::format("from {:.4g} to {}", from, x(to));
  }

  std::string operator()(const Flat& e) const {
    return fmt::format("is flat: {} is never above {}", words.metric, y(e.most));
  }
  std::string operator()(const Diverges& e) const {
    return fmt::format("diverges: {} is at most {} {}, above {} {}", words.metric, y(e.holds),
                       stretch(-kNoEnd, e.up_to), y(e.fails), stretch(e.from, kNoEnd));
  }
  std::string operator()(const FailsIn& e) const {
    std::string holds;
    if (!std::isinf(e.before)) holds = stretch(-kNoEnd, e.before);
    if (!std::isinf(e.beyond)) holds += (holds.empty() ? "" : " and ") + stretch(e.beyond, kNoEnd);
    return fmt::format("fails {}: {} is above {} there, at most {} {}", stretch(e.from, e.to), words.metric, y(e.fails),
                       y(e.holds), holds);
  }
  std::string operator()(const Grows& e) const {
    return fmt::format("goes with the power {:.4g} (within {:.2g}) of the {} {}: {} is {:.4g} to {} at {}", e.slope,
                       e.tolerance, words.parameter, stretch(e.from, e.to), words.metric, e.low, y(e.high), x(e.at));
  }
  std::string operator()(const Wobbles& e) const {
    const std::string by = std::isinf(e.most) ? "at least " + y(e.least)
                           : e.least <= 0     ? "at most " + y(e.most)
                                              : fmt::format("{:.4g} to {}", e.least, y(e.most));
    return fmt::format("wobbles by {}: from the smallest {} to the largest", by, words.metric);
  }
  std::string operator()(const Least& e) const {
    return fmt::format("has its least value {}: {} is at most {} there, above {} at both ends", stretch(e.from, e.to),
                       words.metric, y(e.most), y(e.ends));
  }
  std::string operator()(const FailsOften& e) const {
    const std::string which = words.families
                                  ? fmt::format(" of family {}", "ABC"[std::clamp(int(e.from) / kFamilySpan, 0, 2)])
                                  : ", " + stretch(e.from, e.to);
    if (e.share <= 0) return fmt::format("never fails: {} is above {} in none{}", words.metric, y(e.bound), which);
    return fmt::format("fails often: {} is above {} in about {:.2g} %{}, give or take chance", words.metric, y(e.bound),
                       100 * e.share, which);
  }
};

// ---- the check ------------------------------------------------------------------------------------------------------

bool at_most(double value, double bound) { return value <= bound; }  // false for NaN
bool above(double value, double bound) { return !at_most(value, bound); }

struct Checker {
  std::span<const CurvePoint> points;

  // The first point from `from` to `to` for which the claim is not true; a claim about nothing is not true either.
  template <class Claim>
  Verdict every(double from, double to, Claim claim, const std::string& claimed) const {
    size_t judged = 0;
    for (const CurvePoint& p : points) {
      if (p.x < from || p.x > to) continue;
      ++judged;
      if (!p.value) return {false, fmt::format("at {:.6g} nothing was measured", p.x)};
      if (!claim(*p.value)) return {false, fmt::format("at {:.6g} it is {:.4g}, not {}", p.x, *p.value, claimed)};
    }
    if (judged == 0) return {false, fmt::format("nothing was measured from {:.6g} to {:.6g}", from, to)};
    return {true, ""};
  }
  Verdict all_at_most(double from, double to, double bound) const {
    return every(
        from, to, [=](double v) { return at_most(v, bound); }, fmt::format("at most {:.4g}", bound));
  }
  Verdict all_above(double from, double to, double bound) const {
    return every(
        from, to, [=](double v) { return above(v, bound); }, fmt::format("above {:.4g}", bound));
  }

  Verdict operator()(const Flat& e) const { return all_at_most(-kNoEnd, kNoEnd, e.most); }

  Verdict operator()(const Diverges& e) const {
    const Verdict before = all_at_most(-kNoEnd, e.up_to, e.holds);
    return before.holds ? all_above(e.from, kNoEnd, e.fails) : before;
  }

  Verdict operator()(const FailsIn& e) const {
    Verdict v = all_above(e.from, e.to, e.fails);
    if (v.holds && !std::isinf(e.before)) v = all_at_most(-kNoEnd, e.before, e.holds);
    if (v.holds && !std::isinf(e.beyond)) v = all_at_most(e.beyond, kNoEnd, e.holds);
    return v;
  }

  // Least squares of log value on log x.
  Verdict operator()(const Grows& e) const {
    Verdict positive = every(
        e.from, e.to, [](double v) { return v > 0 && std::isfinite(v); }, "a number above 0");
    if (!positive.holds) return positive;
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const CurvePoint& p : points) {
      if (p.x < e.from || p.x > e.to) continue;
      const double x = std::log(p.x / e.at), y = std::log(*p.value);
      n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    const double determinant = n * sxx - sx * sx;
    if (n < 3 || !(determinant > 0)) return {false, "fewer than three points: no line can be drawn"};
    const double slope = (n * sxy - sx * sy) / determinant, level = std::exp((sy - slope * sx) / n);
    if (!(std::abs(slope - e.slope) <= e.tolerance)) return {false, fmt::format("the power is {:.3f}", slope)};
    if (!(level >= e.low && level <= e.high))
      return {false, fmt::format("at {:.6g} the line is at {:.4g}", e.at, level)};
    for (const CurvePoint& p : points) {
      if (p.x < e.from || p.x > e.to) continue;
      const double off = *p.value / (level * std::pow(p.x / e.at, slope));
      if (!(off <= e.spread && off >= 1 / e.spread))
        return {false, fmt::format("at {:.6g} it is {:.4g}, {:.2f} times the line", p.x, *p.value, off)};
    }
    return {true, ""};
  }

  Verdict operator()(const Wobbles& e) const {
    const Verdict finite = every(
        -kNoEnd, kNoEnd, [](double v) { return std::isfinite(v); }, "a finite number");
    if (!finite.holds) return finite;
    const auto [low, high] = std::minmax_element(
        points.begin(), points.end(), [](const CurvePoint& a, const CurvePoint& b) { return *a.value < *b.value; });
    const double wobble = *high->value - *low->value;
    if (wobble >= e.least && wobble <= e.most) return {true, ""};
    return {false, fmt::format("it wobbles by {:.4g}, from {:.4g} at {:.6g} to {:.4g} at {:.6g}", wobble, *low->value,
                               low->x, *high->value, high->x)};
  }

  Verdict operator()(const Least& e) const {
    const Verdict finite = every(
        -kNoEnd, kNoEnd, [](double v) { return std::isfinite(v); }, "a finite number");
    if (!finite.holds) return finite;
    const CurvePoint& least = *std::min_element(
        points.begin(), points.end(), [](const CurvePoint& a, const CurvePoint& b) { return *a.value < *b.value; });
    if (least.x < e.from || least.x > e.to || above(*least.value, e.most))
      return {false, fmt::format("its least value is {:.4g}, at {:.6g}", *least.value, least.x)};
    for (const CurvePoint& end : {points.front(), points.back()})
      if (!above(*end.value, e.ends))
        return {false, fmt::format("at {:.6g} it is {:.4g}, not above {:.4g}", end.x, *end.value, e.ends)};
    return {true, ""};
  }

  Verdict operator()(const FailsOften& e) const {
    size_t judged = 0, failed = 0;
    for (const CurvePoint& p : points) {
      if (p.x < e.from || p.x > e.to) continue;
      if (!p.value) return {false, fmt::format("at {:.6g} nothing was measured", p.x)};
      ++judged, failed += above(*p.value, e.bound);
    }
    if (judged == 0) return {false, fmt::format("nothing was measured from {:.6g} to {:.6g}", e.from, e.to)};
    const double n = static_cast<double>(judged), share = static_cast<double>(failed) / n;
    // 2.5 standard deviations of a count of n, and 3 % for how well the share itself is known.
    const double scatter = e.share > 0 ? 0.03 + 2.5 * std::sqrt(e.share * (1 - e.share) / n) : 0;
    if (std::abs(share - e.share) <= scatter) return {true, ""};
    return {false, fmt::format("it is {:.3g} % ({} of {})", 100 * share, failed, judged)};
  }
};

}  // namespace

std::string text_of(const Expected& expected, const AxisWords& words) { return std::visit(Writer{words}, expected); }

Verdict check(const Expected& expected, std::span<const CurvePoint> points) {
  return std::visit(Checker{points}, expected);
}

}  // namespace gbl
