// `study`: a product of set-ups, each measured as a row; resumed, shared between machines, and drawn as a chart.
#include <algorithm>
#include <cmath>
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
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/base/made_by.h"
#include "renderer/opening/scene_look.h"
#include "renderer/study/row_json.h"
#include "renderer/study/study.h"
#include "renderer/study/study_files.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

std::string time_left(std::optional<double> seconds) {
  if (!seconds) return "";
  const long s = std::lround(*seconds);
  return s >= 120 ? fmt::format(", {} min left", (s + 30) / 60) : fmt::format(", {} s left", s);
}

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

}  // namespace

ExitCode run_study_command(const Arguments& a) {
  const Given given = given_of(a);
  const StudySpec spec = with_given(load_study(a.what.empty() ? "tradeoff" : a.what), given.state, given.explicitly);
  const Shard shard = a.shard ? parse_shard(*a.shard) : Shard{};
  const HeadlessContext context;
  Lab lab(without_of(a));
  const StudyPlan plan = expand(
      spec, [](const std::string& name) { return open_scene(name); }, lab.limits());
  print_left_out(plan);
  const fs::path folder = a.output.value_or(fs::path("out") / spec.name);
  make_folder(folder);
  Journal journal(folder / "rows.jsonl", made_by());
  Bench bench(lab.renderer(), lab.cost(), lab.machine(), 3);
  const InterruptScope scope;
  const StudyCounts counts = run_study(
      plan, shard, journal, [&](const StudyCase& c) { return measured_columns(lab, bench, c.settings, folder); },
      print_progress, scope.interrupted());
  const std::vector<StudyRow> rows = rows_of(plan, journal.rows());
  write_study_files(folder, spec, rows, lab.machine(), bench_command);
  const std::string summary = fmt::format("{}: {} rows measured, {} found, {} failed, {} left", spec.name,
                                          counts.measured, counts.before, counts.failed, counts.left);
  if (a.json)
    fmt::print("{}\n", study_json(spec, rows, lab.machine()).dump(2));
  else
    fmt::print("{}; study.html, .csv, .json, .svg, .png in {}\n", summary, folder.string());
  if (scope.interrupted()) return ExitCode::interrupted;
  return counts.failed > 0 ? ExitCode::check_failed : ExitCode::done;
}

}  // namespace gbl
