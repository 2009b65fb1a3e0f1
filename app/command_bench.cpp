// `bench`: a study of one row, printed.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/bench.h"
#include "app/calibration.h"
#include "app/commands.h"
#include "app/growth.h"
#include "app/headless.h"
#include "app/lab.h"
#include "app/micro_bench.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/options/settings_json.h"
#include "renderer/study/charts/gnuplot.h"
#include "renderer/study/row_json.h"
#include "renderer/study/rows/growth.h"
#include "renderer/study/rows/paired_ratio.h"

namespace gbl {
namespace {

void print_json(const MeasuredColumns& row) {
  Json json;
  append_cells(json, row.cells);
  json["settings"] = to_json(row.drawn);
  fmt::print("{}\n", json.dump(2));
}

// The median of a time whose run spread too far.
bool is_noisy_median(const StudyRow& row, std::string column) {
  constexpr std::string_view kMedian = "_median";
  if (!column.ends_with(kMedian)) return false;
  const std::string time = column.substr(0, column.size() - kMedian.size());
  return is_noisy(row, {.id = std::move(column), .p10 = time + "_p10", .p90 = time + "_p90"});
}

void print_text(const MeasuredColumns& row) {
  const StudyRow measured{.cells = row.cells};
  for (const Cell& c : row.cells) {
    const auto* n = std::get_if<Number>(&c.value);
    const bool rounded = n && !n->whole && !std::isinf(n->value);
    const std::string text = is_noisy_median(measured, c.column) ? "noisy"
                             : rounded                           ? fmt::format("{:.4g}", n->value)
                                                                 : cell_text(c.value);
    if (!std::holds_alternative<std::monostate>(c.value)) fmt::print("{:<34} {}\n", c.column, text);
  }
}

BenchWishes wishes_of(const Arguments& a) {
  BenchWishes wishes{.errors = !a.no_truth, .times = a.frames != 0};
  if (a.frames) wishes.frames = *a.frames, wishes.all_frames = true;
  return wishes;
}

// Wall time until the GPU has finished, of a frame from its settings to `lit`.
double wall_ms(Lab& lab, const Settings& s, Targets& targets) {
  glFinish();
  targets.clusters.clusters.forget();  // as if the camera had moved
  const double begin = now_s();
  lab.renderer().render(s, *lab.gpu_scene(), targets);
  glFinish();
  return (now_s() - begin) * 1e3;
}

struct PairedTimes {
  std::vector<double> a, b;
};
PairedTimes time_in_turn(Lab& lab, const Settings& a, const Settings& b, int rounds) {
  Targets of_a, of_b;
  PairedTimes times;
  for (int round = -1; round < rounds; ++round) {
    const double ms_a = wall_ms(lab, a, of_a), ms_b = wall_ms(lab, b, of_b);
    if (round >= 0) times.a.push_back(ms_a), times.b.push_back(ms_b);  // the first compiles programs
  }
  return times;
}

struct Compared {
  const char* name;
  TimeSpread ms;
  std::optional<double> off;  // share of the pixels, 0..1; none without the reference
  int bytes;                  // per pixel, of G-buffer and sums
};
Compared compared(const char* name, const std::vector<double>& ms, Lab& lab, const Settings& s, const Arguments& a) {
  Bench bench(lab.renderer(), lab.cost(), lab.machine(), 1);
  bench.start(s, lab.gpu_scene(), {.errors = !a.no_truth, .times = false});
  bench.step(true);
  const FrameReport& r = bench.report();
  return {name, spread_of(ms), bench.errors().over_half_255_display,
          r.gbuffer_bytes_per_pixel + r.accumulation_bytes_per_pixel};
}

// B is A with the options of --against.
ExitCode run_against(const Arguments& a) {
  if (a.frames == 0)
    throw Error(ExitCode::bad_input, "--frames", "0 frames give no ratio", "give 1 or more, or leave it out");
  const auto [first, scene] = setup_of(a);
  Settings second = first;
  for (const std::string& assignment : a.against) apply_typed(second, assignment);
  const HeadlessContext context(api_of(a));
  Lab lab(without_of(a));
  if (scene) lab.show(first.scene, scene);
  for (const Settings& s : {first, second}) require_valid(s, lab.limits());
  if (second.scene != first.scene)
    throw Error(ExitCode::bad_input, "--against", "both draw the same scene", "choose it with --scene");
  lab.open(first.scene);
  constexpr int kRounds = 21;
  const PairedTimes times = time_in_turn(lab, first, second, a.frames.value_or(kRounds));
  const PairedRatio ratio = paired_ratio(times.a, times.b);
  const Compared both[] = {compared("A", times.a, lab, first, a), compared("B", times.b, lab, second, a)};
  if (a.json) {
    Json json{
        {"ratio", ratio.median}, {"ratio_low", ratio.low}, {"ratio_high", ratio.high}, {"rounds", times.a.size()}};
    for (const Compared& c : both)
      json[c.name] = {{"wall_ms_median", c.ms.median},
                      {"over_half_255_display", c.off ? Json(*c.off) : Json()},
                      {"bytes_per_pixel", c.bytes}};
    fmt::print("{}\n", json.dump(2));
    return ExitCode::done;
  }
  for (const Compared& c : both)
    fmt::print("{}  {:8.2f} ms  {:3} bytes per pixel  {}\n", c.name, c.ms.median, c.bytes,
               c.off ? fmt::format("{:.4g} % of the pixels off by more than half a code of 255", 100 * *c.off)
                     : "errors not measured");
  fmt::print("B takes {:.3f} of A's time ({:.3f} to {:.3f}{}; {} rounds in turn)\n", ratio.median, ratio.low,
             ratio.high, times.a.size() < kLeastRounds ? "" : " with 95 % confidence", times.a.size());
  return ExitCode::done;
}

// Unless another scene is asked for, one that is all wall.
Arguments of_own_choice(Arguments a, const char* flag) {
  if (!a.against.empty() || a.frames || a.lights || a.no_truth)
    throw Error(ExitCode::bad_input, flag, "it chooses its own frames, lights and set-ups, and measures no error",
                "leave out --against, --frames, --lights and --no-truth");
  if (!a.scene) a.scene = "builtin:hall";
  return a;
}

// Every light reaches all of the picture.
Arguments with_pairs(Arguments a) {
  a = of_own_choice(std::move(a), "--micro");
  a.set.insert(a.set.begin(), "lights.range-scale=1000");
  return a;
}

ExitCode run_micro(const Arguments& a) {
  const auto [s, scene] = setup_of(with_pairs(a));
  const HeadlessContext context(api_of(a));
  Lab lab(without_of(a));
  if (scene) lab.show(s.scene, scene);
  lab.open(s.scene);
  const std::vector<MicroRow> rows = run_micro_bench(lab.renderer(), *lab.gpu_scene(), s, lab.limits());
  if (a.json) {
    Json json = Json::array();
    for (const MicroRow& r : rows)
      json.push_back({{"group", r.group},
                      {"what", r.what},
                      {"ns_per_pair", r.ns_per_pair},
                      {"arithmetic_ns_per_pair", r.arithmetic_ns ? Json(*r.arithmetic_ns) : Json()}});
    fmt::print("{}\n", json.dump(2));
    return ExitCode::done;
  }
  fmt::print("{}\n{:<62}{:>8}  {:>10}\n", lab.device().renderer, "ns per pair, lighting of whole frames", "frame",
             "arithmetic");
  for (const MicroRow& r : rows)
    fmt::print("{:<62}{:>8.2f}  {:>10}\n", r.group + " = " + r.what, r.ns_per_pair,
               r.arithmetic_ns ? fmt::format("{:.2f}", *r.arithmetic_ns) : "-");
  return ExitCode::done;
}

ExitCode run_calibrate(const Arguments& a) {
  const std::optional<std::filesystem::path> file = calibration_file();
  if (!file)
    throw Error(ExitCode::unfinished, "--calibrate", "neither XDG_STATE_HOME nor HOME names a folder to keep it in",
                "set XDG_STATE_HOME");
  const auto [s, scene] = setup_of(of_own_choice(a, "--calibrate"));
  const HeadlessContext context(api_of(a));
  Lab lab(without_of(a));
  if (scene) lab.show(s.scene, scene);
  lab.open(s.scene);
  const std::vector<MeasuredWork> measured = measure_work(lab.renderer(), *lab.gpu_scene(), s, lab.limits());
  if (measured.empty())
    throw Error(ExitCode::unfinished, "--calibrate", "no pass took a time that this driver can measure",
                "choose a larger --size");
  const WorkWeights weights = fit_weights(measured);
  keep_calibration(*file, lab.device(), weights);
  const double off = median_misfit(measured, weights);
  if (a.json) {
    Json json{{"device", lab.device().renderer}, {"set_ups", measured.size()}, {"median_misfit", off}};
    json["ns_per_unit"] = weights.ns_per_unit;
    for (const WorkRow& r : kWork) json["units"][r.id] = weights.units[r.work];
    fmt::print("{}\n", json.dump(2));
    return ExitCode::done;
  }
  fmt::print("{}\n{} set-ups; half of the predictions are within {:.0f} % of their times; a turn takes {:.3g} ns\n\n",
             lab.device().renderer, measured.size(), 100 * off, weights.ns_per_unit);
  fmt::print("{:<14} {:>9} {:>9}  units, as built in and here, of a …\n", "work", "llvmpipe", "here");
  for (const WorkRow& r : kWork)
    fmt::print("{:<14} {:>9.4g} {:>9.4g}  {}\n", r.id, r.llvmpipe, weights.units[r.work], r.counts);
  fmt::print("\nkept in {}\n", file->string());
  return ExitCode::done;
}

std::string bend_of(const GrowthAxis& axis, const std::vector<GrowthPoint>& points) {
  const std::optional<double> bend = growth_bend(points);
  if (!bend) return fmt::format("hardly grows with the {}", axis.id);
  return *bend == points.front().x ? fmt::format("goes with the {} from the beginning", axis.id)
                                   : fmt::format("begins to go with the {} at {:.4g}", axis.id, *bend);
}

void refuse_beside_growth(const Arguments& a, const GrowthAxis& axis) {
  const auto refuse = [&](const char* option) {
    throw Error(ExitCode::bad_input, "--growth", fmt::format("{} cannot be combined with {}", option, axis.id),
                "leave it out");
  };
  const std::pair<bool, const char*> other_runs[] = {{!a.against.empty(), "--against"},
                                                     {a.micro, "--micro"},
                                                     {a.calibrate, "--calibrate"},
                                                     {a.no_truth, "--no-truth"},
                                                     {a.frames == 0, "--frames 0"}};
  for (const auto& [given, option] : other_runs)
    if (given) refuse(option);
  const std::pair<bool, const char*> choices[] = {{a.lights.has_value(), "--lights"},
                                                  {a.size.has_value(), "--size"},
                                                  {a.scene.has_value(), "--scene"},
                                                  {a.camera.has_value(), "--camera"}};
  for (const auto& [given, option] : choices)
    if (given && std::find(axis.chooses.begin(), axis.chooses.end(), option) != axis.chooses.end()) refuse(option);
}

ExitCode run_growth(const Arguments& a) {
  const GrowthAxis& axis = growth_axis(a.growth);
  refuse_beside_growth(a, axis);
  if (a.output) {  // what is missing is said before minutes are spent
    make_folder(*a.output);
    run_gnuplot("set terminal svg\nplot 1\n");
  }
  const auto [s, scene] = setup_of(a);
  const HeadlessContext context(api_of(a));
  Lab lab(without_of(a));
  if (scene) lab.show(s.scene, scene);
  lab.open(s.scene);
  constexpr int kFrames = 7;
  if (!a.json)
    fmt::print("{}: {}\n{:>12} {:>9} {:>9} {:>9} {:>13} {:>11} {:>12} {:>10}\n", axis.label, axis.help, axis.id, "ms",
               "fill ms", "rest ms", "tested/pixel", "targets MiB", "resident MiB", "upload ms");
  const auto say = [&](const GrowthRow& r) {
    if (!a.json)
      fmt::print("{:>12.6g} {:>9.2f} {:>9.2f} {:>9.2f} {:>13.3g} {:>11.1f} {:>12.0f} {:>10.0f}\n", r.x, r.total_ms,
                 r.geometry_ms, r.rest_ms, r.tested_per_pixel, r.targets_mib, r.resident_mib, r.upload_ms);
  };
  const std::vector<GrowthRow> rows = measure_growth(lab, s, axis, std::max(1, a.frames.value_or(kFrames)), say);
  std::vector<GrowthPoint> points;
  for (const GrowthRow& r : rows) points.push_back({r.x, r.total_ms});
  if (points.size() < 2)
    throw Error(ExitCode::unfinished, "--growth", "fewer than two points could be measured",
                "choose a smaller --size, or a scene in which lights reach something");
  const std::vector<double> powers = growth_powers(points);
  if (a.json) {
    Json json{{"axis", axis.id}, {"powers", powers}, {"bend", nullptr}, {"rows", Json::array()}};
    if (const auto bend = growth_bend(points)) json["bend"] = *bend;
    for (const GrowthRow& r : rows)
      json["rows"].push_back({{"x", r.x},
                              {"total_ms", r.total_ms},
                              {"geometry_ms", r.geometry_ms},
                              {"rest_ms", r.rest_ms},
                              {"tested_per_pixel", r.tested_per_pixel},
                              {"targets_mib", r.targets_mib},
                              {"resident_mib", r.resident_mib},
                              {"upload_ms", r.upload_ms}});
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("powers between them: {:.2f}\nThe time of a frame {}.\n", fmt::join(powers, ", "),
               bend_of(axis, points));
  }
  if (!a.output) return ExitCode::done;
  const auto file = *a.output / fmt::format("growth-{}.svg", axis.id);
  write_text_file(file, run_gnuplot(growth_script(axis, rows, lab.device().renderer)));
  if (!a.json) fmt::print("{}\n", file.string());
  return ExitCode::done;
}

}  // namespace

ExitCode run_bench(const Arguments& a) {
  if (a.output && a.growth.empty())
    throw Error(ExitCode::bad_input, "--output", "only --growth writes a file", "leave it out, or add --growth");
  if (!a.growth.empty()) return run_growth(a);
  if (a.micro && a.calibrate)
    throw Error(ExitCode::bad_input, "--calibrate", "cannot be combined with --micro", "give one of them");
  if (a.calibrate) return run_calibrate(a);
  if (a.micro) return run_micro(a);
  if (!a.against.empty()) return run_against(a);
  const auto [s, scene] = setup_of(a);
  const HeadlessContext context(api_of(a));
  Lab lab(without_of(a));
  if (scene) lab.show(s.scene, scene);
  require_valid(s, lab.limits());
  lab.open(s.scene);
  Bench bench(lab.renderer(), lab.cost(), lab.machine(), 1);
  bench.start(s, lab.gpu_scene(), wishes_of(a));
  bench.step(true);
  const MeasuredColumns row = bench.row();
  say_choices(lab.renderer().resolve(s, *lab.gpu_scene())->choices);
  if (a.json)
    print_json(row);
  else
    print_text(row);
  return ExitCode::done;
}

}  // namespace gbl
