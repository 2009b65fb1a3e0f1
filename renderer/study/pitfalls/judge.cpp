#include "renderer/study/pitfalls/judge.h"

#include <fmt/format.h>

#include "renderer/base/error.h"

namespace gbl {

PitfallBounds bounds_on(const PitfallEntry& e, const DeviceRounding& rounding) {
  const bool truncates = rounding.half_store == StoreRounding::toward_zero ||
                         rounding.half_blend == StoreRounding::toward_zero ||
                         rounding.r11 == StoreRounding::toward_zero;
  return truncates && e.toward_zero ? *e.toward_zero : e.bounds;
}

std::string number_text(std::optional<double> n) { return n ? fmt::format("{:.3g}", *n) : "not measured"; }

std::string judge_numbers(const PitfallEntry& e, const PitfallBounds& b, std::optional<double> broken,
                          std::optional<double> fixed, std::optional<double> blind) {
  std::string wrong;
  const auto not_as = [&](const char* what, std::optional<double> n, const char* relation, double bound) {
    wrong += fmt::format("{}{}: {} is {}, not {} {:g}", wrong.empty() ? "" : "; ", what, e.metric, number_text(n),
                         relation, bound);
  };
  if (!(broken && *broken >= b.broken_at_least)) not_as("broken", broken, "at least", b.broken_at_least);
  if (!(fixed && *fixed <= b.fixed_at_most)) not_as("fixed", fixed, "at most", b.fixed_at_most);
  if (e.blind && !(blind && *blind <= e.blind->at_most)) not_as("where it hides", blind, "at most", e.blind->at_most);
  return wrong;
}

// Another device could draw it; what no device can draw is an entry's mistake.
static bool of_the_device(ProblemId id) {
  return id == ProblemId::feature_missing || id == ProblemId::too_many_targets || id == ProblemId::size_above_limit;
}

PitfallResult judge_pitfall(const PitfallEntry& e, glm::ivec2 size, const DeviceLimits& limits,
                            const DeviceRounding& rounding, const PitfallMeasureFn& measure) {
  PitfallResult out;
  const PitfallMetric& metric = pitfall_metric(e.metric);
  const auto number_of = [&](PitfallSide side) -> std::optional<double> {
    Settings drawn = settings_of(e, side), meant = truth_of(e, side);
    drawn.size = meant.size = size;
    if (const std::vector<Problem> problems = validate(drawn, limits); !problems.empty()) {
      const Problem& p = problems[0];
      if (!of_the_device(p.id)) throw Error(ExitCode::bad_input, e.id, p.path + " " + p.sentence);
      out.skipped = p.path + " " + p.sentence;
      return {};
    }
    return value_of(metric, measure(drawn, meant));
  };
  out.broken = number_of(PitfallSide::broken);
  out.fixed = number_of(PitfallSide::fixed);
  if (e.blind) out.blind = number_of(PitfallSide::blind);
  if (!out.skipped.empty()) return out;

  out.wrong = judge_numbers(e, bounds_on(e, rounding), out.broken, out.fixed, out.blind);
  return out;
}

}  // namespace gbl
