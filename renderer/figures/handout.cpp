#include "renderer/figures/handout.h"

#include <cassert>
#include <cmath>
#include <fmt/format.h>

#include "renderer/base/base64.h"
#include "renderer/inspect/views.h"
#include "renderer/picture/svg.h"

namespace gbl {
namespace {

constexpr int kLinesToWrite = 4;

// XML's rules hold in HTML, too.
std::string escaped(std::string_view text) { return svg_escaped(text); }

constexpr const char* kStyle = R"(
@page { size: A4; margin: 18mm; }
body { font: 11pt/1.4 "DejaVu Serif", Georgia, serif; color: #111; background: #fff; max-width: 174mm; margin: 0 auto; padding: 0 4mm; }
h1 { font-size: 20pt; line-height: 1.2; margin: 0 0 4mm; }
h2 { font-size: 12pt; margin: 0 0 2mm; color: #333; }
section { break-inside: avoid; margin: 0 0 8mm; }
img { display: block; width: 100%; border: 0.3mm solid #999; }
.look { color: #333; font-size: 10pt; margin: 1.5mm 0; }
.command { font: 8.5pt/1.4 "DejaVu Sans Mono", monospace; color: #333; overflow-wrap: anywhere; margin: 1.5mm 0; }
.question { font-weight: bold; margin: 3mm 0 0; }
.write { border-bottom: 0.25mm solid #777; height: 8mm; }
#answers { break-before: page; }
#answers li { margin: 0 0 3mm; }
footer { font-size: 9pt; color: #555; margin-top: 8mm; }
)";

std::string html_step(const LessonStep& step, const HandoutFigure& figure, size_t number) {
  std::string out = fmt::format("<section>\n<h2>{}</h2>\n<p>{}</p>\n", number, escaped(step.say));
  out +=
      fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">\n", escaped(figure.words.alt), base64(figure.png));
  out += fmt::format("<p class=\"look\">{}</p>\n<p class=\"command\">{}</p>\n", escaped(figure.look_at),
                     escaped(figure.words.command));
  if (!step.question.empty()) {
    out += fmt::format("<p class=\"question\">{}</p>\n", escaped(step.question));
    for (int k = 0; k < kLinesToWrite; ++k) out += "<div class=\"write\"></div>\n";
  }
  return out + "</section>\n";
}

bool asks_anything(const Lesson& lesson) {
  for (const LessonStep& s : lesson.steps)
    if (!s.question.empty()) return true;
  return false;
}

std::string view_by_hand(const LessonStep& step) {
  const ViewRow& v = row(view_by_id(step.view).view);
  const std::string key = *v.key ? v.key : v.view == View::error ? "U" : "O";
  return fmt::format("`{}` {}{}", key, v.label, step.large ? "" : ", `0` all panels");
}

// What the step changes, by the keys that change it, too. A place is not found by hand.
std::string by_hand(const LessonStep& step) {
  std::string out = step.view.empty() ? "" : view_by_hand(step);
  bool moved = false;
  for (const Assignment& a : step.set) {
    const Option& o = option(a.path);
    moved |= a.path.starts_with("camera.");
    if (o.kind == Kind::vector || a.path.starts_with("camera.")) continue;
    out += fmt::format("{}`{}` {}: {}", out.empty() ? "" : "; ", *o.key ? o.key : "O", o.label, plain(a.value));
  }
  if (moved) out += out.empty() ? "the camera moves" : "; the camera moves";
  return out;
}

double minutes_of(const Lesson& lesson) {
  double sum = 0;
  for (const LessonStep& s : lesson.steps) sum += s.minutes;
  return sum;
}

// What the lecturer prints and hands out.
std::string for_the_class(const Lesson& lesson, const std::string& name) {
  std::string out = fmt::format(
      "\n## For the class\n\nThe handout, with figures, questions and the answers on its last page; and figures for "
      "notes of your own:\n\n"
      "```\ngbufferlab handout {} -o out/handout\ngbufferlab figures sources -o out/figures\n```\n",
      name);
  if (lesson.exercises.empty()) return out;
  out += "\nExercises that go with it. Each writes its task and what to begin with:\n\n```\n";
  for (const std::string& e : lesson.exercises) out += fmt::format("gbufferlab exercise {0} -o out/exercises/{0}\n", e);
  return out +
         "```\n\n`gbufferlab exercise NAME --check FILE` judges one answer. The answers of a class are files "
         "`answers/STUDENT/NAME.json` "
         "(or `.glsl`), and `gbufferlab exercise --grade answers --csv` judges them all.\n";
}

}  // namespace

std::string handout_markdown(const Lesson& lesson, const std::vector<HandoutFigure>& figures) {
  assert(figures.size() == lesson.steps.size());
  std::string out = fmt::format("# {}\n", lesson.title), answers;
  for (size_t k = 0; k < lesson.steps.size(); ++k) {
    const LessonStep& step = lesson.steps[k];
    const FigureWords& w = figures[k].words;
    out += fmt::format("\n## {}\n\n{}\n\n![{}]({})\n\n{}\n\n```\n{}\n```\n", k + 1, step.say, markdown_escaped(w.alt),
                       w.file, figures[k].look_at, w.command);
    if (step.question.empty()) continue;
    out += fmt::format("\n**{}**\n", step.question);
    for (int line = 0; line < kLinesToWrite; ++line) out += "\n" + std::string(70, '.') + "\n";
    answers += fmt::format("\n{}. {}\n", k + 1, step.answer);
  }
  if (!answers.empty()) out += "\n---\n\n## Answers\n" + answers;
  return out + fmt::format("\nMade with G-Buffer Lab {}.\n", figures.empty() ? "" : figures[0].words.made_by);
}

std::string handout_html(const Lesson& lesson, const std::vector<HandoutFigure>& figures) {
  assert(figures.size() == lesson.steps.size());
  std::string body = fmt::format("<h1>{}</h1>\n", escaped(lesson.title)), answers;
  for (size_t k = 0; k < lesson.steps.size(); ++k) {
    body += html_step(lesson.steps[k], figures[k], k + 1);
    if (!lesson.steps[k].question.empty())
      answers += fmt::format("<li value=\"{}\">{}</li>\n", k + 1, escaped(lesson.steps[k].answer));
  }
  if (asks_anything(lesson))
    body += fmt::format("<section id=\"answers\">\n<h2>Answers</h2>\n<ol>\n{}</ol>\n</section>\n", answers);
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}<footer>Made with G-Buffer Lab "
      "{}.</footer>\n</body>\n</html>\n",
      escaped(lesson.title), kStyle, body, figures.empty() ? "" : escaped(figures[0].words.made_by));
}

std::string lecture_script(const Lesson& lesson, const std::string& name) {
  const double all = minutes_of(lesson);
  std::string out = fmt::format(
      "# {}\n\n{} steps, {:g} minutes. Everything is done from the keyboard:\n\n```\ngbufferlab view --lesson {} "
      "--present\n```\n\n"
      "`PgDn` goes on, `PgUp` goes back, `Enter` shows the answer. `F9` points with a ring, `F10` shows the time. "
      "`Ctrl+Shift+P` brings the "
      "other panels. *By hand* names the keys that do the same without the lesson: the key goes through an option's "
      "values, and `O` lists all options.\n",
      lesson.title, lesson.steps.size(), all, name);
  double at = 0;
  for (size_t k = 0; k < lesson.steps.size(); ++k) {
    const LessonStep& step = lesson.steps[k];
    const long second = std::lround(60 * at);
    out += fmt::format("\n## {}. At {}:{:02}, {:g} min\n\n", k + 1, second / 60, second % 60, step.minutes);
    out += fmt::format("- Press: {}\n- Say: {}\n", k == 0 ? "nothing: the lesson opens here" : "`PgDn`", step.say);
    if (!step.question.empty())
      out += fmt::format("- Ask: {}\n- Wait, then press `Enter`: {}\n", step.question, step.answer);
    if (const std::string keys = by_hand(step); !keys.empty()) out += fmt::format("- By hand: {}\n", keys);
    at += step.minutes;
  }
  return out + for_the_class(lesson, name);
}

}  // namespace gbl
