// `bench`: a study of one row, printed.
#include <cmath>
#include <fmt/format.h>

#include "app/bench.h"
#include "app/commands.h"
#include "app/headless.h"
#include "app/lab.h"
#include "renderer/base/json.h"
#include "renderer/options/settings_json.h"
#include "renderer/study/row_json.h"

namespace gbl {
namespace {

void print_json(const MeasuredColumns& row) {
  Json json;
  append_cells(json, row.cells);
  json["settings"] = to_json(row.drawn);
  fmt::print("{}\n", json.dump(2));
}

void print_text(const MeasuredColumns& row) {
  for (const Cell& c : row.cells) {
    const auto* n = std::get_if<Number>(&c.value);
    const bool rounded = n && !n->whole && !std::isinf(n->value);
    const std::string text = rounded ? fmt::format("{:.4g}", n->value) : cell_text(c.value);
    if (!std::holds_alternative<std::monostate>(c.value)) fmt::print("{:<34} {}\n", c.column, text);
  }
}

BenchWishes wishes_of(const Arguments& a) {
  BenchWishes wishes{.errors = !a.no_truth, .times = a.frames != 0};
  if (a.frames) wishes.frames = *a.frames, wishes.all_frames = true;
  return wishes;
}

}  // namespace

ExitCode run_bench(const Arguments& a) {
  const auto [s, scene] = setup_of(a);
  const HeadlessContext context;
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
