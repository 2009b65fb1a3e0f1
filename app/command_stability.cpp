// `stability`: one parameter through the place where a method breaks; every curve with a statement that is checked.
#include <algorithm>
#include <fmt/format.h>
#include <unistd.h>

#include "app/commands.h"
#include "app/headless.h"
#include "app/interrupt.h"
#include "app/stability_bench.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/study/stability/stability_chart.h"
#include "renderer/study/stability/stability_files.h"
#include "renderer/study/stability/stability_journal.h"

namespace gbl {
namespace {

// In the order of the table, whatever the order on the line; none named: all.
std::vector<const Sweep*> chosen_sweeps(const std::vector<std::string>& ids) {
  std::vector<const Sweep*> named, out;
  for (const std::string& id : ids) named.push_back(&sweep(id));
  for (const Sweep& s : sweeps())
    if (named.empty() || std::find(named.begin(), named.end(), &s) != named.end()) out.push_back(&s);
  return out;
}

void show_progress(const Sweep& s, size_t done, size_t total) {
  if (done % 16 == 0 && isatty(STDERR_FILENO)) fmt::print(stderr, "\r{}: {} of {} \033[K", s.id, done, total);
}

void print_families(const CurveResult& c) {
  for (int family = 0; family < kFamilies; ++family) {
    const FamilyShares s = family_shares(c, family);
    fmt::print("        {}: {:.0f} % of {} configurations wrong, {:.1f} % of lit pixels lost, worst error {:.3g}\n",
               "ABC"[family], 100 * s.wrong, s.configurations, 100 * s.lost, s.worst_linear);
  }
}

void print_curve(const Sweep& s, const CurveResult& c) {
  if (!c.not_drawn.empty()) fmt::print("  skipped {}: {}\n", c.curve, c.not_drawn);
  for (const Judged& j : c.judged) {
    fmt::print("  {} {} {}", j.verdict.holds ? "holds  " : "DOES NOT HOLD", c.curve, j.statement);
    fmt::print("{}\n", j.verdict.holds ? "" : ". But " + j.verdict.where);
  }
  if (has_families(s) && c.not_drawn.empty()) print_families(c);
}

void print_text(const SweepResult& result) {
  if (isatty(STDERR_FILENO)) fmt::print(stderr, "\r\033[K");
  fmt::print("{}: {}\n", result.sweep->id, result.sweep->label);
  for (const CurveResult& c : result.curves) print_curve(*result.sweep, c);
  if (result.left > 0) fmt::print("  not judged: {} points have not been measured\n", result.left);
}

bool fails(const SweepResult& r) { return r.left == 0 && !r.holds(); }

// 1: a statement does not hold. What other machines measure is no failure.
ExitCode outcome(const std::vector<SweepResult>& results, bool interrupted) {
  if (interrupted) return ExitCode::interrupted;
  return std::any_of(results.begin(), results.end(), fails) ? ExitCode::check_failed : ExitCode::done;
}

}  // namespace

ExitCode run_stability(const Arguments& a) {
  const std::vector<const Sweep*> chosen = chosen_sweeps(a.sweeps);
  if (a.configurations && std::none_of(chosen.begin(), chosen.end(), [](const Sweep* s) { return has_families(*s); }))
    throw Error(ExitCode::bad_input, "--configurations", "none of these sweeps has families of configurations",
                "leave it out, or name cull-families");
  const Shard shard = a.shard ? parse_shard(*a.shard) : Shard{};
  const std::filesystem::path folder = a.output.value_or("out/stability");
  make_folder(folder);  // before the work: a folder that cannot be written is known at once
  const HeadlessContext context;
  const gl::Device device = gl::probe_device(without_of(a));
  Renderer renderer;
  StabilityBench bench(renderer, device);
  Journal journal(folder / "points.jsonl", sweeps_made_by(bench.machine(), bench.limits().features));
  const InterruptScope scope;
  std::vector<SweepResult> results;
  for (const Sweep* s : chosen) {
    const auto measure = [&](const SweepSetup& setup) { return bench.measure(setup); };
    SweepRun run{.limits = bench.limits(), .rounding = bench.rounding(), .shard = shard, .journal = &journal};
    if (has_families(*s) && a.configurations) run.values = family_values(*a.configurations);
    results.push_back(run_sweep(*s, run, measure, show_progress, scope.interrupted()));
    if (!a.json) print_text(results.back());
  }
  if (a.json) fmt::print("{}\n", stability_json(results, bench.machine(), bench.rounding()).dump(1));
  write_stability_files(folder, results, bench.machine(), bench.rounding());
  return outcome(results, scope.interrupted());
}

}  // namespace gbl
