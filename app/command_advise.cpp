// `advise`: the cheapest set-up for a scene that holds an error budget, what it leaves out and why, and the runner-up.
#include <cmath>
#include <fmt/format.h>
#include <unistd.h>

#include "app/advice_bench.h"
#include "app/commands.h"
#include "app/headless.h"
#include "app/interrupt.h"
#include "app/lab.h"
#include "app/picture_texts.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/options/settings_json.h"
#include "renderer/study/advice/advice_page.h"

namespace gbl {
namespace {

ErrorBudget budget_of(const Arguments& a) {
  if (a.budget && a.budget_max)
    throw Error(ExitCode::bad_input, "--budget", "and --budget-max are both given", "choose one of them");
  const double codes = a.budget_max.value_or(a.budget.value_or(1));
  if (!(codes > 0 && codes <= 255))
    throw Error(ExitCode::bad_input, a.budget_max ? "--budget-max" : "--budget",
                fmt::format("{} is not in 0 ... 255", codes), "give codes of 255 as displayed, e.g. 1 or 0.5");
  return {codes / 255, a.budget_max ? 0 : 0.001};
}

AdviceCost cost_of(const std::string& id) {
  std::vector<std::string_view> known;
  for (const AdviceCostRow& r : kAdviceCosts) {
    if (id == r.id) return r.cost;
    known.emplace_back(r.id);
  }
  throw Error(ExitCode::bad_input, "--cost", fmt::format("unknown cost '{}'", id), suggest(id, known));
}

// One line that is written over on a terminal; in a log a line every so often.
void show_progress(const std::string& what) {
  constexpr double kLogSeconds = 10;
  static double last_s = 0;
  const bool terminal = isatty(STDERR_FILENO);
  if (!terminal && (what.empty() || now_s() - last_s < kLogSeconds)) return;
  last_s = now_s();
  fmt::print(stderr, "{}{:.110}{}", terminal ? "\r\033[K" : "", what, terminal ? "" : "\n");
  std::fflush(stderr);
}

Json json_of(const BoundCheck& b) {
  return {{"compared", b.compared},
          {"excused", b.excused},
          {"over", b.over},
          {"share_over", b.share_over()},
          {"worst_codes", 255 * b.worst},
          {"worst_pixel", {b.worst_pixel.x, b.worst_pixel.y}}};
}

Json json_of(const Tried& t) {
  return {{"what", in_words(t.values)}, {"holds", t.holds}, {"camera", t.camera}, {"worst", json_of(t.worst)}};
}

Json json_of(const std::vector<Tried>& all) {
  Json out = Json::array();
  for (const Tried& t : all) out.push_back(json_of(t));
  return out;
}

Json json_of(const std::optional<AdvisedSetup>& s) {
  if (!s) return nullptr;
  return {{"setup", in_words(setup_values(s->settings))},
          {"cost", s->cost},
          {"bytes_per_pixel", s->bytes_per_pixel},
          {"camera", s->proof.camera},
          {"worst", json_of(s->proof.worst)},
          {"together", s->together ? json_of(*s->together) : Json(nullptr)},
          {"settings", to_json(s->settings)}};
}

Json json_of(const std::vector<AdvisedSetup>& all) {
  Json out = Json::array();
  for (const AdvisedSetup& s : all) out.push_back(json_of(std::optional(s)));
  return out;
}

Json json_of(const std::vector<SightChoice>& all) {
  Json out = Json::array();
  for (const SightChoice& c : all)
    out.push_back({{"taken", in_words(c.tried[c.taken].values)}, {"tried", json_of(c.tried)}});
  return out;
}

void print_setup(const char* title, const std::optional<AdvisedSetup>& s, AdviceCost cost) {
  if (!s) return;
  const std::string cost_text = std::isnan(s->cost) ? "" : fmt::format("{:.4g} {}, ", s->cost, row(cost).unit);
  fmt::print("{}: {}{} bytes per pixel\n  {}\n", title, cost == AdviceCost::bytes ? "" : cost_text, s->bytes_per_pixel,
             in_words(setup_values(s->settings)));
  fmt::print("  worst of {} cameras: {} of {} pixels over, the worst by {:.2f} codes at {}, {}; {} excused\n",
             kAdviceCameras, s->proof.worst.over, s->proof.worst.compared, 255 * s->proof.worst.worst,
             s->proof.worst.worst_pixel.x, s->proof.worst.worst_pixel.y, s->proof.worst.excused);
}

void print_text(const Advice& advice, AdviceCost cost) {
  if (cost == AdviceCost::time && !advice.measured.empty())
    fmt::print(
        "the fastest of {} set-ups that hold and were measured; bytes and pairs are searched wholly, times are not\n",
        advice.measured.size());
  print_setup(advice.stopped ? "stopped; cheapest so far" : "cheapest", advice.best, cost);
  print_setup("runner-up", advice.runner_up, cost);
  if (advice.best && advice.best->together)
    fmt::print(
        "  with shadows, mirrors and height maps: {:.3g} % of the pixels over from camera {}, the worst by {:.2f} "
        "codes\n",
        100 * advice.best->together->worst.share_over(), advice.best->together->camera,
        255 * advice.best->together->worst.worst);
  for (const AdvisedSetup& m : advice.measured)
    fmt::print("measured: {:8.4g} {}  {:3} B/px  {}\n", m.cost, row(cost).unit, m.bytes_per_pixel,
               in_words(setup_values(m.settings)));
  for (const Tried& t : advice.rejected)
    fmt::print("does not hold together: {} ({} pixels over, worst {:.2f} codes)\n", in_words(t.values), t.worst.over,
               255 * t.worst.worst);
  if (!advice.left_out.empty()) fmt::print("left out:\n");
  for (const std::string& l : advice.left_out) fmt::print("  {}\n", l);
}

}  // namespace

ExitCode run_advise(const Arguments& a) {
  const ErrorBudget budget = budget_of(a);
  const AdviceCost cost = cost_of(a.cost);
  const std::filesystem::path folder = a.output.value_or("out");
  const bool writes = a.apply || a.output;
  if (writes) make_folder(folder);  // before the work: one that cannot be written is known at once
  const auto [s, scene] = setup_of(a);
  const HeadlessContext context(api_of(a));
  Lab lab(without_of(a));
  if (scene) lab.show(s.scene, scene);
  lab.open(s.scene);
  AdviceBench bench(lab, budget, cost);
  const JudgeFn judge = [&](const Settings& setup, int camera) {
    bench.start_bound(setup, camera);
    bench.step(true);
    return bench.bound();
  };
  const CostFn measure = [&](const Settings& setup) {
    bench.start_cost(setup);
    bench.step(true);
    return bench.cost();
  };
  show_progress("the reference from the first camera");
  const InterruptScope scope;
  const Advice advice =
      advise(s, lab.scene(), budget, cost, lab.limits(), judge, measure, show_progress, scope.interrupted());
  show_progress("");
  const AdviceAsked asked{s, budget, cost, lab.limits().features};
  const auto command = [](const Settings& setup) { return command_line("gbufferlab bench", setup); };
  if (writes) write_text_file(folder / "advice.html", page_html(advice_page(advice, asked, lab.machine(), command)));
  if (a.json)
    fmt::print("{}\n", Json{{"best", json_of(advice.best)},
                            {"runner_up", json_of(advice.runner_up)},
                            {"values", json_of(advice.values)},
                            {"rejected", json_of(advice.rejected)},
                            {"measured", json_of(advice.measured)},
                            {"sights", json_of(advice.sights)},
                            {"left_out", advice.left_out},
                            {"stopped", advice.stopped},
                            {"cost_unit", row(cost).unit}}
                           .dump(2));
  else
    print_text(advice, cost);
  if (advice.stopped) return ExitCode::interrupted;
  if (!advice.best) {
    fmt::print(stderr, "gbufferlab: no set-up holds this budget: even float32 is beyond it somewhere\n");
    return ExitCode::check_failed;
  }
  if (a.apply) {
    write_text_file(folder / "settings.json", settings_text(advice.best->settings) + "\n");
    fmt::print(stderr, "gbufferlab: written to {}; use it with --state\n", (folder / "settings.json").string());
  }
  return ExitCode::done;
}

}  // namespace gbl
