// `study`: a product of set-ups, each measured as a row; resumed, shared between machines, and drawn as a chart.
#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <set>
#include <unistd.h>

#include "app/bench.h"
#include "app/commands.h"
#include "app/headless.h"
#include "app/interrupt.h"
#include "app/lab.h"
#include "app/picture_texts.h"
#include "app/progress_line.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/base/made_by.h"
#include "renderer/opening/scene_look.h"
#include "renderer/study/row_json.h"
#include "renderer/study/study.h"
#include "renderer/study/study_axes.h"
#include "renderer/study/study_files.h"
#include "renderer/study/study_merge.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

// One line that is written over on a terminal; in a log a line every so often.
void print_progress(const StudyProgress& p) {
  const bool terminal = isatty(STDERR_FILENO);
  if (!terminal && p.next && p.done % 20 != 0) return;
  const std::string what = p.next ? p.next->id : "done";
  fmt::print(stderr, "{}{}/{}{}{}  {:.100}{}", terminal ? "\r\033[K" : "", p.done, p.total, time_left(p.seconds_left),
             p.failed > 0 ? fmt::format(", {} failed", p.failed) : "", what, terminal && p.next ? "" : "\n");
  std::fflush(stderr);
}

void print_left_out(const StudyPlan& plan) {
  size_t invalid = 0;
  for (const LeftOut& l : plan.left_out) {
    if (l.by != LeftOutBy::invalid) continue;
    if (++invalid <= 5) fmt::print(stderr, "gbufferlab: left out: {}: {}\n", l.id, l.reason);
  }
  if (invalid > 5) fmt::print(stderr, "gbufferlab: and {} more cases that this device cannot draw\n", invalid - 5);
}

// The folder may hold rows of the same study of another scene: on one chart they would not belong together. Those of other machines
// stay, although this one may not be able to draw them.
std::vector<StudyRow> rows_of(const StudyPlan& plan, const std::vector<StudyRow>& all) {
  std::set<std::string> keys;
  std::vector<const Settings*> truths;
  const auto same = [&](const Settings& s) {
    return std::any_of(truths.begin(), truths.end(), [&](const Settings* t) { return same_truth(*t, s); });
  };
  for (const StudyCase& c : plan.cases) {
    keys.insert(row_key(c.settings));
    if (!same(c.settings)) truths.push_back(&c.settings);
  }
  std::vector<StudyRow>
      out;  // a row's settings are as drawn: by its key it is found even where something was chosen for it
  std::copy_if(all.begin(), all.end(), std::back_inserter(out),
               [&](const StudyRow& r) { return keys.count(r.key) > 0 || same(r.settings); });
  return out;
}

// Its pictures come first: a row that is kept has them.
MeasuredColumns measured_columns(Lab& lab, Bench& bench, const Settings& s, const fs::path& folder) {
  require_valid(s, lab.limits());
  lab.open(s.scene);
  bench.start(s, lab.gpu_scene(), {});
  bench.step(true);
  write_thumbnails(folder, row_key(s), bench.thumbnails());
  return bench.row();
}

std::string bench_command(const Settings& s) { return command_line("gbufferlab bench", s); }

std::shared_ptr<const Scene> scene_called(const std::string& name) { return open_scene(name); }

// A study by its name or file, or made from the names of options, of what the line gives.
StudySpec asked_study(const Arguments& a) {
  if (a.axes && !a.what.empty())
    throw Error(ExitCode::bad_input, "--axes", fmt::format("makes a study of its own, and '{}' is another", a.what),
                "leave one of them out");
  const Given given = given_of(a);
  return with_given(a.axes ? study_of_axes(*a.axes) : load_study(a.what.empty() ? "tradeoff" : a.what), given.state,
                    given.explicitly);
}

fs::path folder_of(const Arguments& a, const StudySpec& spec) { return a.output.value_or(fs::path("out") / spec.name); }

void print_outcome(const Arguments& a, const StudySpec& spec, const std::vector<StudyRow>& rows, const Machine& machine,
                   const std::string& summary, const fs::path& folder) {
  if (a.json)
    fmt::print("{}\n", study_json(spec, rows, machine).dump(2));
  else
    fmt::print("{}: {}; study.html, .csv, .json, .svg, .png in {}\n", spec.name, summary, folder.string());
}

// ---- --merge --------------------------------------------------------------------------------------------------------

void refuse_beside_merge(const Arguments& a) {
  const auto refuse = [](const char* what) {
    throw Error(ExitCode::bad_input, "--merge", fmt::format("and {} are both given", what),
                "leave it out: the folders say what study they hold");
  };
  if (!a.what.empty()) refuse("a study");
  if (a.axes) refuse("--axes");
  if (a.shard) refuse("--shard");
  if (a.time_budget) refuse("--budget");
  if (!a.without.empty()) refuse("--without");
  const Given given = given_of(a);
  if (!given.state.empty() || !given.explicitly.empty()) refuse("settings");
  if (!a.output) throw Error(ExitCode::bad_input, "--merge", "needs a folder to write to", "add -o DIR");
}

// Any device could have measured these rows.
DeviceLimits any_device() {
  DeviceLimits limits;
  for (const FeatureRow& f : kFeatures) limits.features.add(f.feature);
  return limits;
}

// As one run would have them: by the plan, then what this plan has not.
void sort_by_plan(std::vector<StudyRow>& rows, const StudyPlan& plan) {
  std::map<std::string, size_t> places;
  for (const StudyCase& c : plan.cases) places.emplace(row_key(c.settings), places.size());
  const auto place = [&](const StudyRow& r) {
    const auto found = places.find(r.key);
    return found == places.end() ? places.size() : found->second;
  };
  std::stable_sort(rows.begin(), rows.end(), [&](const auto& x, const auto& y) { return place(x) < place(y); });
}

ExitCode merge_studies(const Arguments& a) {
  refuse_beside_merge(a);
  const fs::path folder = *a.output;
  std::vector<fs::path> folders = a.merge;
  MergedRows merged = merged_rows(folders);  // before anything is written
  make_folder(folder);
  const Journal lock(folder / "rows.jsonl");  // nobody else writes to it now
  if (!lock.rows().empty()) {                 // what was merged before, or measured here
    folders.push_back(folder);
    merged = merged_rows(folders);
  }
  const StudyPlan plan = expand(merged.spec, scene_called, any_device());
  sort_by_plan(merged.rows, plan);
  std::string lines;
  for (const StudyRow& row : merged.rows)
    lines += journal_line(row);  // those that belong to no chart of this plan, too
  merge_thumbnails(folders, folder, merged.rows);
  const std::vector<StudyRow> rows = rows_of(plan, merged.rows);
  write_text_file(folder / "rows.jsonl", lines);
  write_spec(folder, merged.spec);
  write_study_files(folder, merged.spec, rows, {}, bench_command);
  const auto failed = std::count_if(rows.begin(), rows.end(), [](const StudyRow& r) { return r.failed.has_value(); });
  print_outcome(a, merged.spec, rows, {},
                fmt::format("{} rows merged, {} of them failed, of {} set-ups", rows.size(), failed, plan.cases.size()),
                folder);
  return ExitCode::done;
}

}  // namespace

ExitCode run_study_command(const Arguments& a) {
  if (!a.merge.empty()) return merge_studies(a);
  const StudySpec spec = asked_study(a);
  const Shard shard = a.shard ? parse_shard(*a.shard) : Shard{};
  std::optional<double> budget_s;
  if (a.time_budget) budget_s = parse_duration(*a.time_budget, "--budget");
  const HeadlessContext context(api_of(a));
  Lab lab(without_of(a));
  const StudyPlan plan = expand(spec, scene_called, lab.limits());
  print_left_out(plan);
  const fs::path folder = folder_of(a, spec);
  make_folder(folder);
  Journal journal(folder / "rows.jsonl", made_by());
  write_spec(folder, spec);
  Bench bench(lab.renderer(), lab.cost(), lab.machine(), 3);
  const InterruptScope scope;
  const StudyCounts counts = run_study(
      plan, shard, journal, [&](const StudyCase& c) { return measured_columns(lab, bench, c.settings, folder); },
      print_progress, scope.interrupted(), budget_s);
  const std::vector<StudyRow> rows = rows_of(plan, journal.rows());
  write_study_files(folder, spec, rows, lab.machine(), bench_command);
  print_outcome(
      a, spec, rows, lab.machine(),
      fmt::format("{} rows measured, {} found, {} failed, {} left{}", counts.measured, counts.before, counts.failed,
                  counts.left, budget_s && counts.left > 0 ? " (the same command goes on)" : ""),
      folder);
  if (scope.interrupted()) return ExitCode::interrupted;
  return counts.failed > 0 ? ExitCode::check_failed : ExitCode::done;
}

}  // namespace gbl
