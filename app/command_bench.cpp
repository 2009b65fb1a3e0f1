// `bench`: one set-up measured as a row of a study is: repeated frames, with views and overlays off.
#include <chrono>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/headless.h"
#include "app/lab.h"
#include "renderer/study/study_row.h"

namespace gbl {
namespace {

constexpr double kCountOnlyMs = 60000;  // a frame predicted longer than this is counted, not timed

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

Timing timed(Lab& lab, const Settings& s) {
  lab.draw(s);  // warm-up: programs are compiled, targets made
  lab.collect(true);
  Timing timing;
  double slowest = 0;
  for (const double start = now_s(); !measured_enough(timing.frames, now_s() - start, slowest); ++timing.frames) {
    const double begin = now_s();
    lab.draw(s);
    lab.collect(true);
    slowest = std::max(slowest, now_s() - begin);
    double total = 0;
    for (const PassTime& p : lab.report().passes) {
      if (!p.ms) continue;
      timing.pass_ms[p.pass].push_back(*p.ms);
      total += *p.ms;
    }
    timing.pass_ms["total"].push_back(total);
  }
  return timing;
}

void print_text(const Json& row) {
  for (const auto& [key, value] : row.items())
    if (!value.is_null() && key != "settings")
      fmt::print("{:<34} {}\n", key,
                 value.is_number_float() ? fmt::format("{:.4g}", value.get<double>())
                 : value.is_string()     ? value.get<std::string>()
                                         : value.dump());
  fmt::print("{:<34} no reference to measure against yet\n", "errors");
}

}  // namespace

ExitCode run_bench(const Arguments& a) {
  const auto [s, scene] = setup_of(a);
  const HeadlessContext context;
  Lab lab(without_of(a));
  if (scene) lab.show(s.scene, scene);
  require_valid(s, lab.limits());
  lab.open(s.scene);
  const bool too_long = lab.cost().predict_ms(s, lights_of(s, lab.scene())) > kCountOnlyMs;
  const Timing timing = too_long ? Timing{} : timed(lab, s);
  lab.draw(s);
  lab.count_pairs(double(s.size.x) * s.size.y * lab.report().light_count <= kMostLitTests);
  lab.collect(true);
  const Json row = study_row(lab.report(), {}, timing, {lab.device().version, lab.device().renderer});
  if (a.json)
    fmt::print("{}\n", row.dump(2));
  else
    print_text(row);
  return ExitCode::done;
}

}  // namespace gbl
