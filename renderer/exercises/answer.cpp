#include "renderer/exercises/answer.h"

#include <algorithm>
#include <fmt/format.h>
#include <sstream>

#include "renderer/base/json.h"
#include "renderer/options/data_file.h"
#include "renderer/options/settings_json.h"

namespace gbl {
namespace {

// "FILE:LINE:COLUMN" of the member's value, or of the file's begin.
std::string place_of(std::string_view text, std::string_view member, const std::string& where) {
  size_t at = text.find(fmt::format("\"{}\"", member));
  if (at == std::string_view::npos) return where + ":1:1";
  at = text.find_first_not_of(" \t\r\n", std::min(text.find(':', at), text.size() - 1) + 1);
  const std::string_view before = text.substr(0, std::min(at, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  return fmt::format("{}:{}:{}", where, line, before.size() - (before.rfind('\n') + 1) + 1);
}

std::string known_choice(const Exercise& e, const Json& answer, const std::string& place) {
  std::vector<std::string_view> known;
  for (const ExerciseChoice& c : e.choices) known.emplace_back(c.id);
  if (!answer.is_string())
    throw Error(ExitCode::bad_input, place, fmt::format("the answer is {}, not a choice in quotes", answer.dump()),
                suggest("", known));
  std::string id = answer.get<std::string>();
  if (std::find(known.begin(), known.end(), id) == known.end())
    throw Error(ExitCode::bad_input, place, fmt::format("'{}' is no choice", id), suggest(id, known));
  return id;
}

glm::ivec2 pixel_inside(const Exercise& e, const Json& answer, const std::string& place) {
  const bool pair =
      answer.is_array() && answer.size() == 2 && answer[0].is_number_integer() && answer[1].is_number_integer();
  if (!pair)
    throw Error(ExitCode::bad_input, place, fmt::format("the answer is {}, not a pixel", answer.dump()),
                "write [x, y] in whole numbers, from the top left");
  const glm::ivec2 size = state_of(e).size;
  const auto x = answer[0].get<long long>(), y = answer[1].get<long long>();
  if (x < 0 || y < 0 || x >= size.x || y >= size.y)
    throw Error(ExitCode::bad_input, place, fmt::format("[{}, {}] lies outside the picture", x, y),
                fmt::format("choose 0 to {} and 0 to {}", size.x - 1, size.y - 1));
  return {x, y};
}

double a_number(const Json& answer, const std::string& place) {
  if (!answer.is_number())
    throw Error(ExitCode::bad_input, place, fmt::format("the answer is {}, not a number", answer.dump()),
                "write a number without quotes");
  return answer.get<double>();
}

void try_patch(const Exercise& e, const std::vector<Assignment>& set, const std::string& place) {
  Settings tried = state_of(e);
  apply_patch(tried, set, place);
}

Answer parse_json_answer(const Exercise& e, std::string_view text, const std::string& where) {
  const Json json = parse_json(text, where);
  if (e.answer == AnswerKind::settings && json.is_object() && json.contains("version") && !json.contains("answer"))
    return answer_of_state(e, from_json(json, where), where);
  only_members(json, {"exercise", "answer"}, where);
  const std::string of = text_member(json, "exercise", where);
  if (!of.empty() && of != e.id)
    throw Error(ExitCode::bad_input, place_of(text, "exercise", where),
                fmt::format("this answers '{}', not '{}'", of, e.id));
  const std::string place = place_of(text, "answer", where);
  if (!json.contains("answer")) throw Error(ExitCode::bad_input, place, "\"answer\" is missing");
  const Json& answer = json["answer"];
  Answer out{.where = where};
  switch (e.answer) {
    case AnswerKind::choice: out.choice = known_choice(e, answer, place); break;
    case AnswerKind::number: out.number = a_number(answer, place); break;
    case AnswerKind::pixel: out.pixel = pixel_inside(e, answer, place); break;
    default: out.set = read_patch(answer, place); try_patch(e, out.set, place);
  }
  return out;
}

// PATH=VALUE, a line each; what follows # is a remark.
Answer parse_lines(const Exercise& e, std::string_view text, const std::string& where) {
  Settings s = state_of(e);
  Answer out{.where = where};
  std::istringstream lines{std::string(text)};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    line = line.substr(0, line.find('#'));
    const size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos) continue;
    line = line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
    if (line.starts_with("--set ")) line = line.substr(6);
    look_up(fmt::format("{}:{}:{}", where, number, first + 1), [&] { apply_assignment(s, line); });
    const std::string path = line.substr(0, line.find('='));
    out.set.push_back({path, option(path).get(s)});
  }
  return out;
}

bool is_json(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && (text[first] == '{' || text[first] == '[');
}

}  // namespace

Answer answer_of_state(const Exercise& e, const Settings& given, const std::string& where) {
  Answer out{.where = where};
  const Settings start = state_of(e);
  for (const Option& o : options()) {
    const bool part =
        o.group != Group::view && std::string_view(o.path) != "size" && std::string_view(o.path) != "time_s";
    if (part && o.get(given) != o.get(start)) out.set.push_back({o.path, o.get(given)});
  }
  return out;
}

Answer parse_answer(const Exercise& e, std::string_view text, const std::string& where) {
  if (e.answer == AnswerKind::glsl || e.answer == AnswerKind::layout)
    return {.where = where, .text = std::string(text), .path = where};
  if (e.answer == AnswerKind::settings && !is_json(text)) return parse_lines(e, text, where);
  return parse_json_answer(e, text, where);
}

const char* ending_of(const Exercise& e) {
  return e.answer == AnswerKind::glsl || e.answer == AnswerKind::layout ? "glsl" : "json";
}

std::string template_of(const Exercise& e) {
  if (!e.start.empty()) return fmt::format("{}\n", fmt::join(e.start, "\n"));
  Json json;
  json["exercise"] = e.id;
  switch (e.answer) {
    case AnswerKind::number: json["answer"] = 0; break;
    case AnswerKind::pixel: json["answer"] = {0, 0}; break;
    case AnswerKind::settings: json["answer"] = Json::object(); break;
    default: json["answer"] = "";
  }
  return json.dump(2) + "\n";
}

}  // namespace gbl
