// `figures`: every figure of a set, with its captions; or which of a folder's pictures are out of date.
#include <algorithm>
#include <fmt/format.h>
#include <sstream>

#include "app/commands.h"
#include "app/figure_sets.h"
#include "app/figure_writer.h"
#include "app/headless.h"
#include "app/interrupt.h"
#include "app/progress_line.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

std::vector<FigureSpec> chosen(const FigureSet& set, const std::string& only) {
  if (only.empty()) return set.figures;
  std::vector<std::string_view> known;
  for (const FigureSpec& f : set.figures) known.emplace_back(f.id);
  std::vector<FigureSpec> out;
  std::istringstream list(only);
  for (std::string id; std::getline(list, id, ',');) {
    const auto found = std::find(known.begin(), known.end(), id);
    if (found == known.end())
      throw Error(ExitCode::bad_input, fmt::format("--only {}", id),
                  fmt::format("'{}' has no figure of this name", set.name), suggest(id, known));
    out.push_back(set.figures[static_cast<size_t>(found - known.begin())]);
  }
  return out;
}

// A name and a title each: of sets, or of a set's figures.
using Named = std::vector<std::pair<std::string, std::string>>;

void print_names(const Named& rows, bool json) {
  Json out = Json::array();
  for (const auto& [name, title] : rows)
    if (json)
      out.push_back({{"id", name}, {"title", title}});
    else
      fmt::print("{:<28} {}\n", name, title);
  if (json) fmt::print("{}\n", out.dump(2));
}

Named names_of_sets() {
  Named out;
  for (const FigureSetRow& r : figure_sets()) out.emplace_back(r.name, r.title);
  return out;
}

Named names_of(const std::vector<FigureSpec>& figures) {
  Named out;
  for (const FigureSpec& f : figures) out.emplace_back(f.id, f.title);
  return out;
}

ExitCode check_folder(const fs::path& folder, const std::vector<FigureSpec>& figures, FigureMaker& maker, bool json) {
  Json outdated = Json::array();
  ProgressLine progress(figures.size());
  for (const FigureSpec& f : figures) {
    progress.next(f.id);
    const std::string why = why_outdated(folder, f, maker);
    if (why.empty()) continue;
    outdated.push_back({{"figure", f.id}, {"why", why}});
    if (!json) fmt::print("out of date: {}\n", (folder / why).string());
  }
  if (json)
    fmt::print("{}\n", outdated.dump(2));
  else if (outdated.empty())
    fmt::print("{}: {} pictures show what they would show now\n", folder.string(), figures.size());
  return outdated.empty() ? ExitCode::done : ExitCode::check_failed;
}

// What would be passed over without a word is refused.
void require_meant(const Arguments& a) {
  const bool makes =
      a.output || a.exr || a.scale || a.width_cm || a.light || a.grey || a.few_colours || a.pictures_only;
  if (a.what.empty() && (makes || a.check || !a.only.empty()))
    throw Error(ExitCode::bad_input, "figures", "no set of figures is named",
                "name one: `gbufferlab figures` lists them");
  if (a.list && (makes || a.check))
    throw Error(ExitCode::bad_input, "--list", "only lists: leave out what says how figures are made");
  if (a.check && (a.output || a.exr || a.pictures_only || a.few_colours))
    throw Error(ExitCode::bad_input, "--check", "writes nothing",
                "leave out -o, --exr, --pictures-only and --few-colours");
}

void say_made(const Arguments& a, size_t made, size_t all, const fs::path& folder) {
  const char* with = a.pictures_only ? "" : " with captions (.md, .tex, captions.json)";
  fmt::print("{} of {} figures{} in {}\n", made, all, with, folder.string());
}

}  // namespace

ExitCode run_figures(const Arguments& a) {
  require_meant(a);
  if (a.what.empty()) {
    print_names(names_of_sets(), a.json);
    return ExitCode::done;
  }
  const FigureSet set = figures_named(a.what);
  const std::vector<FigureSpec> figures = chosen(set, a.only);
  if (a.list) {
    print_names(names_of(figures), a.json);
    return ExitCode::done;
  }

  const InterruptScope scope;
  const FigureOptions options{.look = {a.scale.value_or(1), a.width_cm.value_or(0), a.light, a.grey},
                              .set = a.what,
                              .numbers = a.exr,
                              .few_colours = a.few_colours,
                              .pictures_only = a.pictures_only,
                              .without = a.without,
                              .interrupted = &scope.interrupted()};
  const HeadlessContext context(api_of(a));
  Lab lab(without_of(a));
  FigureMaker maker(lab, options.look);
  for (const FigureSpec& f : figures) maker.check(f);  // before anything is written
  if (a.check) return check_folder(*a.check, figures, maker, a.json);
  const fs::path folder = a.output.value_or(fs::path("out") / "figures" / fs::path(set.name).stem());
  make_folder(folder);
  std::vector<FigureWords> words;
  ProgressLine progress(figures.size());
  for (const FigureSpec& f : figures) {
    if (scope.interrupted()) break;
    progress.next(f.id);
    if (std::optional<FigureWords> made = write_figure(folder, f, maker, lab.machine(), options))
      words.push_back(std::move(*made));
  }
  if (!a.pictures_only) write_captions(folder, set.title, words);
  if (a.json) {
    Json out = Json::array();
    for (const FigureWords& w : words) out.push_back(caption_json(w));
    fmt::print("{}\n", out.dump(2));
  } else {
    say_made(a, words.size(), figures.size(), folder);
  }
  return words.size() < figures.size() ? ExitCode::interrupted : ExitCode::done;
}

}  // namespace gbl
