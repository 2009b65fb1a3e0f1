// `figures`: every figure of a set, with its captions; or which of a folder's pictures are out of date.
#include <algorithm>
#include <fmt/format.h>
#include <sstream>
#include <unistd.h>

#include "app/commands.h"
#include "app/figure_sets.h"
#include "app/figure_writer.h"
#include "app/headless.h"
#include "app/interrupt.h"
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

// On a terminal one line that is written over.
class Progress {
 public:
  explicit Progress(size_t total) : total_(total), terminal_(isatty(STDERR_FILENO)) {}
  void next(const std::string& id) {
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
    const std::string left = done_ > 0 && spent > 2
                                 ? fmt::format(", about {:.0f} s left", spent / double(done_) * double(total_ - done_))
                                 : "";
    if (terminal_) fmt::print(stderr, "\r\033[K{}/{}{}  {}", done_ + 1, total_, left, id), std::fflush(stderr);
    ++done_;
  }
  ~Progress() {
    if (terminal_ && done_ > 0) fmt::print(stderr, "\r\033[K");
  }

 private:
  size_t total_, done_ = 0;
  bool terminal_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

ExitCode check_folder(const fs::path& folder, const std::vector<FigureSpec>& figures, FigureMaker& maker, bool json) {
  Json outdated = Json::array();
  Progress progress(figures.size());
  for (const FigureSpec& f : figures) {
    progress.next(f.id);
    const fs::path path = folder / (f.id + (f.drawing.empty() ? ".png" : ".svg"));
    const std::string why = why_outdated(path, f, maker);
    if (why.empty()) continue;
    outdated.push_back({{"file", path.string()}, {"why", why}});
    if (!json) fmt::print("out of date: {} {}\n", path.string(), why);
  }
  if (json)
    fmt::print("{}\n", outdated.dump(2));
  else if (outdated.empty())
    fmt::print("{}: {} pictures show what they would show now\n", folder.string(), figures.size());
  return outdated.empty() ? ExitCode::done : ExitCode::check_failed;
}

}  // namespace

ExitCode run_figures(const Arguments& a) {
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
  const FigureOptions options{
      {a.scale.value_or(1), a.width_cm.value_or(0), a.light, a.grey}, a.what, a.exr, a.few_colours, a.pictures_only};
  const HeadlessContext context;
  Lab lab(without_of(a));
  FigureMaker maker(lab, options.look);
  for (const FigureSpec& f : figures) maker.check(f);  // before anything is written
  if (a.check) return check_folder(*a.check, figures, maker, a.json);
  const fs::path folder = a.output.value_or(fs::path("out") / "figures" / fs::path(set.name).stem());
  make_folder(folder);
  std::vector<FigureWords> words;
  const InterruptScope scope;
  Progress progress(figures.size());
  for (const FigureSpec& f : figures) {
    if (scope.interrupted()) break;
    progress.next(f.id);
    words.push_back(write_figure(folder, f, maker, lab.machine(), options));
  }
  if (!a.pictures_only) write_captions(folder, set.title, words);
  if (a.json) {
    Json out = Json::array();
    for (const FigureWords& w : words) out.push_back(caption_json(w));
    fmt::print("{}\n", out.dump(2));
  } else {
    fmt::print("{} of {} figures with captions (.md, .tex, captions.json) in {}\n", words.size(), figures.size(),
               folder.string());
  }
  return words.size() < figures.size() ? ExitCode::interrupted : ExitCode::done;
}

}  // namespace gbl
