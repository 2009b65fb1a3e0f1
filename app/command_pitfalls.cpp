// `pitfalls`: each entry of the catalogue broken and fixed, judged by the reference; and its page.
#include <fmt/format.h>

#include "app/commands.h"
#include "app/headless.h"
#include "app/pitfall_bench.h"
#include "app/pitfall_strip.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/study/pitfalls/pages.h"

namespace gbl {
namespace {

constexpr glm::ivec2 kSize{320, 180};

std::vector<PitfallEntry> chosen_entries(const std::vector<std::string>& ids) {
  if (ids.empty()) return load_pitfalls();
  std::vector<PitfallEntry> out;
  for (const std::string& id : ids) out.push_back(load_pitfall(id));
  return out;
}

Json json_of(const PitfallEntry& e, const PitfallResult& r, const PitfallBounds& b) {
  Json j;
  j["id"] = e.id, j["title"] = e.title, j["group"] = e.group, j["metric"] = e.metric;
  j["unit"] = pitfall_metric(e.metric).unit;
  j["broken"] = or_null(r.broken), j["fixed"] = or_null(r.fixed), j["blind"] = or_null(r.blind);
  j["broken_at_least"] = b.broken_at_least, j["fixed_at_most"] = b.fixed_at_most;
  j["skipped"] = r.skipped, j["as_catalogued"] = r.skipped.empty() ? Json(r.holds()) : Json(nullptr);
  j["wrong"] = r.wrong;
  return j;
}

void print(const PitfallEntry& e, const PitfallResult& r) {
  if (!r.skipped.empty()) {
    fmt::print("skipped  {:<28} {}\n", e.id, r.skipped);
    return;
  }
  fmt::print("{}  {:<28} {:>10} -> {:<10} {}\n", r.holds() ? "holds  " : "DIFFERS", e.id, number_text(r.broken),
             number_text(r.fixed), e.metric);
  if (!r.holds()) fmt::print("         {}\n", r.wrong);
}

// Of those that were drawn; the index only of all of them.
void write_pages(const std::filesystem::path& folder, const Arguments& a, const std::vector<JudgedPitfall>& judged,
                 glm::ivec2 size, const PitfallBench& bench) {
  const std::string device = bench.machine().device;
  Lab lab(without_of(a));
  for (const JudgedPitfall& j : judged) {
    if (!j.result.skipped.empty()) continue;
    const PitfallStrip strip = draw_strip(lab, j.entry);
    write_strip(folder / (j.entry.id + ".png"), strip);
    write_text_file(folder / (j.entry.id + ".md"),
                    pitfall_page(j, strip.most_codes, size, bounds_on(j.entry, bench.rounding()), device));
  }
  if (a.pitfalls.empty()) write_text_file(folder / "README.md", pitfall_index(judged, size, device));
}

}  // namespace

ExitCode run_pitfalls(const Arguments& a) {
  const std::vector<PitfallEntry> entries = chosen_entries(a.pitfalls);
  if (a.list) {
    for (const PitfallEntry& e : entries) fmt::print("{:<28} {}\n", e.id, e.title);
    return ExitCode::done;
  }
  const glm::ivec2 size = a.size ? setup_of(a).settings.size : kSize;
  if (a.output) make_folder(*a.output);  // before the work: a folder that cannot be written is known at once
  const HeadlessContext context(api_of(a));
  Renderer renderer;
  PitfallBench bench(renderer, gl::probe_device(without_of(a)));
  Settings sized;
  sized.size = size;
  require_valid(sized, bench.limits());
  const auto measure = [&](const Settings& drawn, const Settings& meant) { return bench.measure(drawn, meant); };
  std::vector<JudgedPitfall> judged;
  Json all = Json::array();
  bool all_hold = true;
  size_t skipped = 0;
  for (const PitfallEntry& e : entries) {
    const PitfallResult r = judge_pitfall(e, size, bench.limits(), bench.rounding(), measure);
    all_hold = all_hold && r.holds(), skipped += !r.skipped.empty();
    judged.push_back({e, r});
    if (a.json)
      all.push_back(json_of(e, r, bounds_on(e, bench.rounding())));
    else
      print(e, r);
  }
  if (a.json) {
    const Machine m = bench.machine();
    const Json file = {{"version", 1},
                       {"machine", {{"driver", m.driver}, {"device", m.device}}},
                       {"size", {size.x, size.y}},
                       {"pitfalls", all}};
    fmt::print("{}\n", file.dump(2));
  }
  if (!a.json && skipped > 0) fmt::print("{} of {} skipped\n", skipped, entries.size());
  if (a.output) write_pages(*a.output, a, judged, size, bench);
  return all_hold ? ExitCode::done : ExitCode::check_failed;
}

}  // namespace gbl
