// `handout`: a lesson as Markdown and as a page to print, with a figure for each step; or the lecturer's script.
#include <filesystem>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/figure_sets.h"
#include "app/figure_writer.h"
#include "app/headless.h"
#include "app/interrupt.h"
#include "app/picture_texts.h"
#include "app/progress_line.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/base/made_by.h"
#include "renderer/figures/handout.h"
#include "renderer/inspect/views.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

std::string look_at(const Lesson& lesson, size_t step) {
  const ViewRow& v = row(view_by_id(view_at(lesson, step)).view);
  return fmt::format("Look at {}. {}", v.label, v.sentence);
}

// Its picture keeps the step's settings: the window opens them.
HandoutFigure made_figure(const fs::path& folder, const Lesson& lesson, size_t step, const FigureSpec& f,
                          FigureMaker& maker, const Machine& machine) {
  const fs::path path = folder / (f.id + ".png");
  const Image image = maker.picture(f);
  const std::string command = fmt::format("gbufferlab view --state {}", shell_quoted(path.filename().string()));
  Settings state = maker.settings();
  state.view.main = view_at(lesson, step);
  PngText texts = picture_texts("gbufferlab view", state, machine);
  texts.push_back({kFigureKey, f.json + "\n"});
  write_indexed_png(path, image, texts);
  return {.words = {.id = f.id,
                    .file = path.filename().string(),
                    .title = f.title,
                    .caption = f.caption,
                    .alt = alt_text(f),
                    .source = "",
                    .command = command,
                    .made_by = made_by()},
          .look_at = look_at(lesson, step),
          .png = read_text_file(path)};
}

ExitCode say_written(const Arguments& a, const Lesson& lesson, const std::vector<fs::path>& files) {
  Json names = Json::array();
  for (const fs::path& f : files) names.push_back(f.string());
  if (a.json)
    fmt::print("{}\n", Json{{"lesson", lesson.id}, {"files", names}}.dump(2));
  else
    for (const fs::path& f : files) fmt::print("{}\n", f.string());
  return ExitCode::done;
}

}  // namespace

ExitCode run_handout(const Arguments& a) {
  const Lesson lesson = load_lesson(a.what);
  const fs::path folder = a.output.value_or(fs::path("out") / "handout");
  make_folder(folder);
  if (a.script && !a.without.empty()) throw Error(ExitCode::bad_input, "--without", "a script has no pictures");
  if (a.script) {
    const fs::path path = folder / (lesson.id + "-script.md");
    write_text_file(path, lecture_script(lesson, a.what));
    return say_written(a, lesson, {path});
  }
  const HeadlessContext context(api_of(a));
  Lab lab(without_of(a));
  FigureMaker maker(lab, {.light = true});
  const FigureSet set = figures_of(lesson);
  for (const FigureSpec& f : set.figures) maker.check(f);
  std::vector<HandoutFigure> figures;
  const InterruptScope scope;
  ProgressLine progress(set.figures.size());
  for (size_t k = 0; k < set.figures.size(); ++k) {
    if (scope.interrupted()) return ExitCode::interrupted;  // the pictures so far stay
    progress.next(set.figures[k].title);
    figures.push_back(made_figure(folder, lesson, k, set.figures[k], maker, lab.machine()));
  }
  const std::vector<fs::path> files = {folder / (lesson.id + ".md"), folder / (lesson.id + ".html")};
  write_text_file(files[0], handout_markdown(lesson, figures));
  write_text_file(files[1], handout_html(lesson, figures));
  return say_written(a, lesson, files);
}

}  // namespace gbl
