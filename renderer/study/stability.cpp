#include "renderer/study/stability.h"

#include <algorithm>

#include "renderer/error.h"
#include "renderer/study/stability_sweeps.h"

namespace gbl {

std::span<const Sweep> sweeps() {
  static const std::vector<Sweep> kSweeps = {light_distance_sweep(), far_plane_sweep(),      volume_level_sweep(),
                                             cull_families_sweep(),  normal_angle_sweep(),   roughness_sweep(),
                                             view_distance_sweep(),  world_offset_sweep(),   near_plane_sweep(),
                                             light_count_sweep(),    range_threshold_sweep()};
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

SweepSetup setup_at(const Sweep& s, const Curve& curve, double value) {
  SweepSetup setup = s.at(value);
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
  return !cancelled;
}

namespace {

SweepRow measured_row(const Sweep& s, const Curve& curve, double x, const SweepSetup& setup, const MeasureFn& measure) {
  const Measured m = measure(setup);
  const SweepMetric& metric = sweep_metric(s.metric);
  return {s.id, curve.id, x, metric.id, value_of(metric, setup, m), m.errors, m.truth ? lit_pixels(*m.truth) : 0};
}

void judge(const Sweep& s, const Curve& curve, CurveResult& result) {
  std::vector<CurvePoint> points;
  for (const SweepRow& r : result.rows) points.push_back({r.x, r.value});
  for (const Expected& e : curve.expected) result.judged.push_back({text_of(e, words_of(s)), check(e, points)});
}

// What the curves are, and which of them this device draws.
std::vector<CurveResult> begin(const Sweep& s, const std::vector<Curve>& curves, double first, const SweepRun& run) {
  std::vector<CurveResult> out;
  for (const Curve& c : curves) {
    const Settings settings = setup_at(s, c, first).settings;
    const std::vector<Problem> problems = validate(settings, run.limits);
    out.push_back({.curve = c.id,
                   .not_drawn = problems.empty() ? "" : problems[0].path + " " + problems[0].sentence,
                   .settings = settings});
  }
  return out;
}

}  // namespace

SweepResult run_sweep(const Sweep& s, const SweepRun& run, const MeasureFn& measure, const SweepProgressFn& progress,
                      const std::atomic<bool>& cancel) {
  std::vector<double> values = run.values.empty() ? s.values() : run.values;
  std::sort(values.begin(), values.end());
  const std::vector<Curve> curves = s.curves(run.rounding);
  SweepResult result{.sweep = &s, .curves = begin(s, curves, values.front(), run)};
  size_t done = 0;
  for (const double x : values) {
    const SweepSetup base = s.at(x);
    for (size_t i = 0; i < curves.size(); ++i) {
      if (cancel) return result.cancelled = true, result;
      if (progress) progress(s, done++, values.size() * curves.size());
      if (!result.curves[i].not_drawn.empty()) continue;
      SweepSetup setup = base;
      curves[i].apply(setup.settings);
      result.curves[i].rows.push_back(measured_row(s, curves[i], x, setup, measure));
    }
  }
  for (size_t i = 0; i < curves.size(); ++i)
    if (result.curves[i].not_drawn.empty()) judge(s, curves[i], result.curves[i]);
  return result;
}

}  // namespace gbl
