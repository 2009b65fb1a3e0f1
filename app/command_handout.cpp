// `handout`: a lesson as Markdown and as a page to print, with a figure for each step; or the lecturer's script.
#include <filesystem>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/figure_sets.h"
#include "app/figure_writer.h"
#include "app/headless.h"
#include "app/picture_texts.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/figures/handout.h"
#include "renderer/inspect/views.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

// The view that the step is about: of a mosaic the one that is marked.
std::string look_at(const Lesson& lesson, size_t step) {
  std::string id = "final";
  for (size_t k = 0; k <= step; ++k)
    if (!lesson.steps[k].view.empty()) id = lesson.steps[k].view;
  const ViewRow& v = row(view_by_id(id).view);
  return fmt::format("Look at {}. {}", v.label, v.sentence);
}

// Its picture keeps the step's settings: the window opens them.
HandoutFigure made_figure(const fs::path& folder, const FigureSpec& f, const std::string& look, FigureMaker& maker,
                          const Machine& machine) {
  const fs::path path = folder / (f.id + ".png");
  const Image image = maker.picture(f);
  const std::string command = fmt::format("gbufferlab view --state {}", shell_quoted(path.filename().string()));
  PngText texts = picture_texts("gbufferlab view", maker.settings(), machine);
  texts.push_back({kFigureKey, f.json + "\n"});
  write_indexed_png(path, image, texts);
  HandoutFigure out{
      {f.id, path.filename().string(), f.title, f.caption, alt_text(f), "", command, texts[1].second, 0}, look, ""};
  out.png = read_text_file(path);
  return out;
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
  if (a.script) {
    const fs::path path = folder / (lesson.id + "-script.md");
    write_text_file(path, lecture_script(lesson));
    return say_written(a, lesson, {path});
  }
  const HeadlessContext context;
  Lab lab(without_of(a));
  FigureMaker maker(lab, {.light = true});
  const FigureSet set = figures_of(lesson);
  for (const FigureSpec& f : set.figures) maker.check(f);
  std::vector<HandoutFigure> figures;
  for (size_t k = 0; k < set.figures.size(); ++k)
    figures.push_back(made_figure(folder, set.figures[k], look_at(lesson, k), maker, lab.machine()));
  const std::vector<fs::path> files = {folder / (lesson.id + ".md"), folder / (lesson.id + ".html")};
  write_text_file(files[0], handout_markdown(lesson, figures));
  write_text_file(files[1], handout_html(lesson, figures));
  return say_written(a, lesson, files);
}

}  // namespace gbl
