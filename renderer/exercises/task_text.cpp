#include "renderer/exercises/task_text.h"

#include <fmt/format.h>
#include <sstream>

#include "renderer/exercises/answer.h"

namespace gbl {
namespace {

constexpr size_t kWidth = 96;

std::string wrapped(const std::string& text) {
  std::istringstream words(text);
  std::string out, line;
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > kWidth) out += line + "\n", line.clear();
    line += (line.empty() ? "" : " ") + word;
  }
  return out + line + "\n";
}

std::string file_of(const Exercise& e) { return fmt::format("{}.{}", e.id, ending_of(e)); }

std::string choices_text(const Exercise& e) {
  std::string out;
  for (const ExerciseChoice& c : e.choices) out += fmt::format("  {:<18} {}\n", c.id, c.text);
  return out;
}

}  // namespace

std::string how_to_answer(const Exercise& e) {
  switch (e.answer) {
    case AnswerKind::choice: return "Write the choice's name as \"answer\".";
    case AnswerKind::number: return "Write the number as \"answer\".";
    case AnswerKind::pixel: return "Write the pixel as \"answer\": [x, y], from the top left.";
    case AnswerKind::settings:
      return fmt::format(
          "Write the options that you change as \"answer\", e.g. {{\"{}\": …}}, or lines of PATH=VALUE; a "
          "state that the lab wrote does as well. You may change: {}.",
          e.free.empty() ? "PATH" : e.free[0], fmt::join(e.free, ", "));
    case AnswerKind::glsl:
      return "Write the function in GLSL 3.30. It is compiled, run and compared with the reference.";
    case AnswerKind::layout: break;
  }
  return "Write the layout's file: its attachments in the first line, pack_material() and unpack_material().";
}

std::string bounds_text(const Exercise& e) {
  std::string out;
  for (const ExerciseBound& b : e.bounds) {
    out += fmt::format("  {:<26}", b.measure);
    if (b.at_least) out += fmt::format(" at least {:g}", *b.at_least);
    if (b.at_most) out += fmt::format("{} at most {:g}", b.at_least ? "," : "", *b.at_most);
    out += "\n";
  }
  if (!e.least.empty()) out += fmt::format("  {:<26} as little as of any choice that holds\n", e.least);
  if (e.answer == AnswerKind::glsl)
    out += fmt::format("  {:<26} at most {:g}\n", e.glsl.error + " error", e.glsl.at_most);
  if (e.answer == AnswerKind::number) out += fmt::format("  {:<26} within {:g} %\n", "the number", 100 * e.relative);
  return out;
}

std::string task_text(const Exercise& e) {
  std::string out = fmt::format("{}: {}\n{}\n{}", e.id, e.title, fmt::format("from: {}\n", e.source), wrapped(e.task));
  if (!e.choices.empty()) out += "\nChoices:\n" + choices_text(e);
  if (const std::string bounds = bounds_text(e); !bounds.empty())
    out += "\nA right answer holds:\n" + bounds + wrapped(e.tolerance);
  out += "\n" + wrapped(how_to_answer(e)) + fmt::format("  gbufferlab exercise {} --check {}\n", e.id, file_of(e));
  return out;
}

std::string task_markdown(const Exercise& e) {
  std::string out = fmt::format("# {}\n\nFrom: {}\n\n{}\n", e.title, e.source, e.task);
  if (!e.choices.empty()) {
    out += "\n| choice | |\n|---|---|\n";
    for (const ExerciseChoice& c : e.choices) out += fmt::format("| `{}` | {} |\n", c.id, c.text);
  }
  if (const std::string bounds = bounds_text(e); !bounds.empty())
    out += fmt::format("\nA right answer holds:\n\n```\n{}```\n\n{}\n", bounds, e.tolerance);
  out += fmt::format(
      "\n{}\n\nThe state is in `state.json`, the answer goes into `{}`:\n\n```\ngbufferlab view --state "
      "state.json\ngbufferlab exercise {} --check {}\n```\n",
      how_to_answer(e), file_of(e), e.id, file_of(e));
  return out;
}

}  // namespace gbl
