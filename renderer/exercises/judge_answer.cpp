#include "renderer/exercises/judge_answer.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/json.h"
#include "renderer/exercises/exercise_measures.h"
#include "renderer/gbuffer/layout_file.h"

namespace gbl {
namespace {

using Value = std::optional<double>;

std::string text_of(Value v) { return v ? fmt::format("{:.4g}", *v) : "not measured"; }

bool holds(const ExerciseBound& b, Value v) {
  return v && (!b.at_least || *v >= *b.at_least) && (!b.at_most || *v <= *b.at_most);
}

std::string range_text(const ExerciseBound& b) {
  if (b.at_least && b.at_most) return fmt::format("{:g} to {:g}", *b.at_least, *b.at_most);
  return b.at_least ? fmt::format("at least {:g}", *b.at_least) : fmt::format("at most {:g}", *b.at_most);
}

// "is 0.03 too much"
std::string off_text(const ExerciseBound& b, Value v) {
  if (!v) return fmt::format("{} could not be measured", b.measure);
  const bool much = b.at_most && *v > *b.at_most;
  const double by = much ? *v - *b.at_most : *b.at_least - *v;
  return fmt::format("{} is {:.4g} too {}", b.measure, by, much ? "large" : "small");
}

using ValueOf = std::function<Value(const ExerciseBound&)>;

ExerciseVerdict judge_bounds(const Exercise& e, const ValueOf& value) {
  ExerciseVerdict v{.right = true};
  for (const ExerciseBound& b : e.bounds) {
    const Value n = value(b);
    v.measured += fmt::format("{}{}={} ({})", v.measured.empty() ? "" : "; ", b.measure, text_of(n), range_text(b));
    if (holds(b, n)) continue;
    v.right = false;
    v.off += (v.off.empty() ? "" : "; ") + off_text(b, n);
    if (v.hint.empty()) v.hint = b.hint.empty() ? e.hint : b.hint;
  }
  return v;
}

Value of_frame(const std::string& measure, const PitfallEvidence& evidence) {
  return value_of(exercise_measure(measure), evidence);
}

Settings with(Settings s, const std::vector<Assignment>& set, const std::string& where) {
  apply_patch(s, set, where);
  return s;
}

PitfallEvidence measured(const Exercise& e, const Settings& drawn, const ExerciseTools& tools) {
  return tools.measure(drawn, with(drawn, e.truth, e.id));
}

ExerciseVerdict judge_frame(const Exercise& e, const Settings& drawn, const ExerciseTools& tools) {
  const PitfallEvidence evidence = measured(e, drawn, tools);
  return judge_bounds(e, [&](const ExerciseBound& b) { return of_frame(b.measure, evidence); });
}

// ---- by kind -------------------------------------------------------------------------------------------------------

ExerciseVerdict judge_hash(const Exercise& e, const Answer& a) {
  const bool right = hash_of_choice(e, a.choice) == e.hash;
  return {right, "", right ? "" : fmt::format("'{}' is not it", a.choice), right ? "" : e.hint};
}

// All choices are drawn: which one is right is in no file.
ExerciseVerdict judge_choice(const Exercise& e, const Answer& a, const ExerciseTools& tools) {
  if (!e.hash.empty()) return judge_hash(e, a);
  ExerciseVerdict mine;
  double least = INFINITY, mine_has = INFINITY;
  for (const ExerciseChoice& c : e.choices) {
    const PitfallEvidence evidence = measured(e, with(state_of(e), c.set, e.id), tools);
    const ExerciseVerdict v = judge_bounds(e, [&](const ExerciseBound& b) { return of_frame(b.measure, evidence); });
    const double has = of_frame(e.least, evidence).value_or(INFINITY);
    if (v.right) least = std::min(least, has);
    if (c.id == a.choice) mine = v, mine_has = has;
  }
  mine.measured += fmt::format("{}{}={}", mine.measured.empty() ? "" : "; ", e.least, text_of(mine_has));
  if (!mine.right || mine_has <= least) return mine;
  mine.right = false, mine.hint = e.hint;
  mine.off = fmt::format("another choice holds as well with {:.0f} % less {}", 100 * (1 - least / mine_has), e.least);
  return mine;
}

ExerciseVerdict judge_number(const Exercise& e, const Answer& a, const ExerciseTools& tools) {
  const auto value = [&](const Settings& s) { return of_frame(e.measure, measured(e, s, tools)); };
  Value is = value(state_of(e));
  if (!e.over.empty()) {
    const Value more = value(with(state_of(e), e.over, e.id));
    is = is && more && *is != 0 ? Value(*more / *is) : std::nullopt;
  }
  if (!is) throw Error(ExitCode::unfinished, e.id, fmt::format("{} could not be measured", e.measure));
  const double off = std::abs(a.number - *is) / std::max(std::abs(*is), 1e-12);
  ExerciseVerdict v{.right = off <= e.relative};
  v.measured = fmt::format("answer={:g}; off by {:.3g} % (at most {:g} %)", a.number, 100 * off, 100 * e.relative);
  if (v.right) return v;
  v.off = fmt::format("{:g} is {:.3g} % too {}", a.number, 100 * off, a.number > *is ? "large" : "small");
  v.hint = e.hint;
  return v;
}

ExerciseVerdict judge_pixel(const Exercise& e, const Answer& a, const ExerciseTools& tools) {
  const PitfallEvidence evidence = measured(e, state_of(e), tools);
  return judge_bounds(e, [&](const ExerciseBound& b) { return value_of(pixel_measure(b.measure), evidence, a.pixel); });
}

bool may_change(const Exercise& e, const std::string& path) {
  return std::any_of(e.free.begin(), e.free.end(), [&](const std::string& f) {
    return f == path || (f.ends_with(".*") && path.starts_with(f.substr(0, f.size() - 1)));
  });
}

ExerciseVerdict judge_settings(const Exercise& e, const Answer& a, const ExerciseTools& tools) {
  const Settings start = state_of(e), drawn = with(start, a.set, a.where);
  for (const Assignment& one : a.set)
    if (option(one.path).get(drawn) != option(one.path).get(start) && !may_change(e, one.path))
      return {false, "", fmt::format("{} is changed, and it must stay as it is", one.path),
              fmt::format("change only {}", fmt::join(e.free, ", "))};
  return judge_frame(e, drawn, tools);
}

ExerciseVerdict judge_layout(const Exercise& e, const Answer& a, const ExerciseTools& tools) {
  return judge_frame(e, with(state_of(e), {{"layout-file", name_layout_file(a.path)}}, a.where), tools);
}

std::string input_text(const GlslInput& in) {
  const auto four = [](const glm::vec4& v) { return fmt::format("({:g}, {:g}, {:g}, {:g})", v.x, v.y, v.z, v.w); };
  return in.b == glm::vec4(0) ? fmt::format("a = {}", four(in.a))
                              : fmt::format("a = {}, b = {}", four(in.a), four(in.b));
}

ExerciseVerdict judge_glsl(const Exercise& e, const Answer& a, const ExerciseTools& tools) {
  const std::vector<GlslInput> inputs = inputs_of(e.glsl);
  const GlslError error = error_of(e.glsl, inputs, tools.run_glsl(a, e.glsl, inputs));
  const std::string unit = unit_of_error(e.glsl);
  ExerciseVerdict v{.right = error.most <= e.glsl.at_most};
  v.measured =
      fmt::format("largest error={:.4g}{}{} (at most {:g})", error.most, unit.empty() ? "" : " ", unit, e.glsl.at_most);
  if (v.right) return v;
  v.off = std::isfinite(error.most) ? fmt::format("off by {:.4g}{}{} for {}", error.most, unit.empty() ? "" : " ", unit,
                                                  input_text(error.worst))
                                    : fmt::format("the result is not a number for {}", input_text(error.worst));
  v.hint = e.hint;
  return v;
}

}  // namespace

bool needs_gl(const Exercise& e) { return e.hash.empty(); }

ExerciseVerdict judge_answer(const Exercise& e, const Answer& a, const ExerciseTools& tools) {
  switch (e.answer) {
    case AnswerKind::choice: return judge_choice(e, a, tools);
    case AnswerKind::number: return judge_number(e, a, tools);
    case AnswerKind::pixel: return judge_pixel(e, a, tools);
    case AnswerKind::settings: return judge_settings(e, a, tools);
    case AnswerKind::glsl: return judge_glsl(e, a, tools);
    case AnswerKind::layout: break;
  }
  return judge_layout(e, a, tools);
}

Json to_json(const ExerciseVerdict& v) {
  return {{"right", v.right}, {"measured", v.measured}, {"off", v.off}, {"hint", v.hint}};
}

ExerciseVerdict verdict_of_json(const Json& j) {
  return {j.at("right").get<bool>(), j.at("measured").get<std::string>(), j.at("off").get<std::string>(),
          j.at("hint").get<std::string>()};
}

}  // namespace gbl
