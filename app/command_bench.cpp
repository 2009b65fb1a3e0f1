// `bench`: a study of one row, printed.
#include <fmt/format.h>

#include "app/bench.h"
#include "app/commands.h"
#include "app/headless.h"
#include "app/lab.h"

namespace gbl {
namespace {

void print_text(const Json& row) {
  for (const auto& [key, value] : row.items())
    if (!value.is_null() && key != "settings")
      fmt::print("{:<34} {}\n", key,
                 value.is_number_float() ? fmt::format("{:.4g}", value.get<double>())
                 : value.is_string()     ? value.get<std::string>()
                                         : value.dump());
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
  bench.start(s, lab.gpu_scene(), {});
  bench.step(true);
  const Json row = bench.row();
  if (a.json)
    fmt::print("{}\n", row.dump(2));
  else
    print_text(row);
  return ExitCode::done;
}

}  // namespace gbl
