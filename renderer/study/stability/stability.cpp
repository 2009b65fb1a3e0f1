#include "renderer/study/stability/stability.h"

#include <algorithm>

#include "renderer/base/error.h"
#include "renderer/study/stability/stability_journal.h"
#include "renderer/study/stability/stability_sweeps.h"

namespace gbl {

std::span<const Sweep> sweeps() {
  static const std::vector<Sweep> kSweeps = {light_distance_sweep(), near_corner_sweep(),     far_plane_sweep(),
                                             volume_level_sweep(),   cull_families_sweep(),   normal_angle_sweep(),
                                             roughness_sweep(),      sub_pixel_pan_sweep(),   view_distance_sweep(),
                                             world_offset_sweep(),   near_plane_sweep(),      depth_decode_sweep(),
                                             light_count_sweep(),    range_threshold_sweep(), shadow_bias_sweep(),
                                             parallax_steps_sweep(), parallax_angle_sweep()};
  return kSweeps;
}

const Sweep& sweep(std::string_view id) {
  std::vector<std::string_view> known;
  for (const Sweep& s : sweeps()) {
    if (s.id == id) return s;
    known.emplace_back(s.id);
  }
  throw Error(ExitCode::bad_input, "stability", std::string("unknown sweep '").append(id).append("'"),
              suggest(id, known));
}

bool has_families(const Sweep& s) { return std::string_view(s.id) == "cull-families"; }

SweepSetup setup_at(const Sweep& s, const Curve& curve, double value, const std::function<void(SweepSetup&)>& over) {
  SweepSetup setup = s.at(value);
  if (over) over(setup);
  curve.apply(setup.settings);
  return setup;
}

AxisWords words_of(const Sweep& s) {
  const SweepMetric& metric = sweep_metric(s.metric);
  return {s.parameter, s.unit, metric.id, metric.unit, has_families(s)};
}

bool SweepResult::holds() const {
  for (const CurveResult& c : curves)
    for (const Judged& j : c.judged)
      if (!j.verdict.holds) return false;
  return left == 0;
}

namespace {

void judge(const Sweep& s, const Curve& curve, CurveResult& result) {
  std::vector<CurvePoint> points;
  for (const SweepRow& r : result.rows) points.push_back({r.x, r.value});
  for (const Expected& e : curve.expected) result.judged.push_back({text_of(e, words_of(s)), check(e, points)});
}

// What the curves are, and which of them this device draws.
std::vector<CurveResult> begin(const Sweep& s, const std::vector<Curve>& curves, double first, const SweepRun& run) {
  std::vector<CurveResult> out;
  for (const Curve& c : curves) {
    const Settings settings = setup_at(s, c, first, run.over).settings;
    const std::vector<Problem> problems = validate(settings, run.limits);
    out.push_back({.curve = c.id,
                   .not_drawn = problems.empty() ? "" : problems[0].path + " " + problems[0].sentence,
                   .settings = settings});
  }
  return out;
}

}  // namespace

SweepRunner::SweepRunner(const Sweep& s, const SweepRun& run)
    : values_(run.values.empty() ? s.values() : run.values), curves_(s.curves(run.rounding)), over_(run.over) {
  std::sort(values_.begin(), values_.end());
  result_ = {.sweep = &s, .curves = begin(s, curves_, values_.front(), run), .given = run.given};
  find_next();
}

void SweepRunner::find_next() {
  const Sweep& s = *result_.sweep;
  while (!complete() && !result_.curves[next_ % curves_.size()].not_drawn.empty()) ++next_;
  if (complete()) {
    for (size_t i = 0; i < curves_.size(); ++i)
      if (result_.curves[i].not_drawn.empty() && result_.left == 0 && result_.given.empty())
        judge(s, curves_[i], result_.curves[i]);
    return;
  }
  const size_t value = next_ / curves_.size();
  if (based_ != value) {
    base_ = s.at(values_[value]), based_ = value;
    if (over_) over_(base_);
  }
  setup_ = base_;
  curves_[next_ % curves_.size()].apply(setup_.settings);
}

SweepRow SweepRunner::row(const Measured& m) const {
  const SweepMetric& metric = sweep_metric(result_.sweep->metric);
  return {.sweep = result_.sweep->id,
          .curve = curve().id,
          .x = value(),
          .metric = metric.id,
          .value = value_of(metric, setup_, m),
          .errors = m.errors,
          .lit_pixels = m.truth ? lit_pixels(*m.truth) : 0};
}

void SweepRunner::add(SweepRow row) {
  result_.curves[next_ % curves_.size()].rows.push_back(std::move(row));
  ++next_;
  find_next();
}

void SweepRunner::skip() {
  ++result_.left;
  ++next_;
  find_next();
}

namespace {

std::string key_of(const SweepRunner& r) {
  return point_key(*r.result().sweep, r.curve(), r.value(), r.setup().settings);
}

std::optional<SweepRow> known_point(const SweepRunner& runner, const Journal* journal) {
  const StudyRow* row = journal ? journal->found(key_of(runner)) : nullptr;
  return row ? std::optional(point_of(*row)) : std::nullopt;
}

SweepRow measured_point(const SweepRunner& runner, Journal* journal, const MeasureFn& measure) {
  SweepRow row = runner.row(measure(runner.setup()));
  if (journal) journal->append(journal_row(key_of(runner), row, runner.setup().settings, journal->made_by()));
  return row;
}

}  // namespace

SweepResult run_sweep(const Sweep& s, const SweepRun& run, const MeasureFn& measure, const SweepProgressFn& progress,
                      const std::atomic<bool>& cancel) {
  SweepRunner runner(s, run);
  while (!runner.complete()) {
    if (progress) progress(s, runner.done(), runner.total());
    if (std::optional<SweepRow> known = known_point(runner, run.journal))
      runner.add(std::move(*known));
    else if (cancel || !run.shard.takes(runner.value_index()))
      runner.skip();
    else
      runner.add(measured_point(runner, run.journal, measure));
  }
  return runner.result();
}

}  // namespace gbl
