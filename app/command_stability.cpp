// `stability`: one parameter through the place where a method breaks; every curve with a statement that is checked.
#include <algorithm>
#include <fmt/format.h>
#include <unistd.h>

#include "app/commands.h"
#include "app/headless.h"
#include "app/interrupt.h"
#include "app/picture_texts.h"
#include "app/stability_bench.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/opening/scene_look.h"
#include "renderer/study/stability/stability_chart.h"
#include "renderer/study/stability/stability_files.h"
#include "renderer/study/stability/stability_given.h"
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

bool is_place_given(const Arguments& a) {
  const bool by_set = std::any_of(a.set.begin(), a.set.end(), [](const std::string& assignment) {
    return is_place(assignment.substr(0, assignment.find('=')));
  });
  return a.scene || a.camera || a.lights || a.rig || a.seed || a.time || by_set;
}

// "--scene model.glb --set ambient=0"
std::string words_of(const Arguments& a) {
  std::string text;
  const auto add = [&](const char* option, const std::string& value) {
    text += fmt::format("{}{} {}", text.empty() ? "" : " ", option, shell_quoted(value));
  };
  if (a.scene) add("--scene", *a.scene);
  if (a.preset) add("--preset", *a.preset);
  if (a.state) add("--state", *a.state);
  if (a.layout_file) add("--layout-file", *a.layout_file);
  if (a.size) add("--size", *a.size);
  if (a.camera) add("--camera", *a.camera);
  if (a.rig) add("--rig", *a.rig);
  if (a.lights) add("--lights", std::to_string(*a.lights));
  if (a.seed) add("--seed", std::to_string(*a.seed));
  if (a.time) add("--time", fmt::format("{}", *a.time));
  for (const std::string& assignment : a.set) add("--set", assignment);
  return text;
}

// Empty: nothing is given, and every sweep is as it is.
std::optional<SweepGiven> given_to_sweeps(const Arguments& a) {
  SweepGiven given{
      .place = is_place_given(a), .state = a.state.has_value(), .ways = a.preset || a.state, .words = words_of(a)};
  if (given.words.empty()) return {};
  Setup setup = setup_of(a);
  given.settings = setup.settings;
  given.scene = setup.scene;
  if (!given.scene && (given.place || given.state)) given.scene = open_scene(setup.settings.scene);
  for (const Assignment& c : given_of(a).explicitly)
    if (c.path != "preset" && c.path != "lights") given.paths.push_back(c.path);
  return given;
}

// A sweep that was named must take what is given; of all of them those are left out that do not.
std::vector<const Sweep*> taking(const std::vector<const Sweep*>& chosen, const SweepGiven& given, bool named) {
  std::vector<const Sweep*> out;
  std::string why;
  for (const Sweep* s : chosen) {
    const std::string refused = refusal(*s, given);
    if (refused.empty()) out.push_back(s);
    if (!refused.empty()) why = refused;
    if (!refused.empty() && !named) fmt::print(stderr, "gbufferlab: left out: {}\n", refused);
    if (!refused.empty() && named) out.clear();
    if (!refused.empty() && named) break;
  }
  if (out.empty()) throw Error(ExitCode::bad_input, given.words, why, "leave it out, or name other sweeps");
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

void print_ends(const CurveResult& c) {
  if (c.rows.empty()) return;
  const auto text = [](const SweepRow& r) {
    return r.value ? fmt::format("{:.4g}", *r.value) : std::string("not measured");
  };
  const SweepRow &first = c.rows.front(), &last = c.rows.back();
  fmt::print("  {}: {} at {:g}, {} at {:g}\n", c.curve, text(first), first.x, text(last), last.x);
}

void print_text(const SweepResult& result) {
  if (isatty(STDERR_FILENO)) fmt::print(stderr, "\r\033[K");
  fmt::print("{}: {}\n", result.sweep->id, result.sweep->label);
  for (const CurveResult& c : result.curves) print_curve(*result.sweep, c);
  if (!result.given.empty()) {
    fmt::print("  measured with {}: what is stated of the sweep's own scene is not judged\n", result.given);
    for (const CurveResult& c : result.curves) print_ends(c);
  }
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
  std::vector<const Sweep*> chosen = chosen_sweeps(a.sweeps);
  const std::optional<SweepGiven> given = given_to_sweeps(a);
  if (given) chosen = taking(chosen, *given, !a.sweeps.empty());
  if (a.configurations && std::none_of(chosen.begin(), chosen.end(), [](const Sweep* s) { return has_families(*s); }))
    throw Error(ExitCode::bad_input, "--configurations", "none of these sweeps has families of configurations",
                "leave it out, or name cull-families");
  const Shard shard = a.shard ? parse_shard(*a.shard) : Shard{};
  const std::filesystem::path folder = a.output.value_or("out/stability");
  make_folder(folder);  // before the work: a folder that cannot be written is known at once
  const HeadlessContext context(api_of(a));
  const gl::Device device = gl::probe_device(without_of(a));
  Renderer renderer;
  StabilityBench bench(renderer, device);
  Journal journal(folder / "points.jsonl", sweeps_made_by(bench.machine(), bench.limits().features));
  const InterruptScope scope;
  std::vector<SweepResult> results;
  for (const Sweep* s : chosen) {
    const auto measure = [&](const SweepSetup& setup) { return bench.measure(setup); };
    SweepRun run{.limits = bench.limits(), .rounding = bench.rounding(), .shard = shard, .journal = &journal};
    if (given) run.over = given_over(*s, *given), run.given = given->words;
    if (has_families(*s) && a.configurations) run.values = family_values(*a.configurations);
    results.push_back(run_sweep(*s, run, measure, show_progress, scope.interrupted()));
    if (!a.json) print_text(results.back());
  }
  if (a.json) fmt::print("{}\n", stability_json(results, bench.machine(), bench.rounding()).dump(1));
  write_stability_files(folder, results, bench.machine(), bench.rounding());
  return outcome(results, scope.interrupted());
}

}  // namespace gbl
