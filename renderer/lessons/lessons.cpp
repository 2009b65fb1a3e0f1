#include "renderer/lessons/lessons.h"

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <fmt/format.h>
#include <limits>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/base/number.h"
#include "renderer/base/resources.h"
#include "renderer/inspect/views.h"
#include "renderer/options/data_file.h"
#include "renderer/options/presets.h"
#include "renderer/options/settings_json.h"

namespace gbl {
namespace {

constexpr int kLessonVersion = 1;
constexpr std::string_view kFolder = "assets/lessons/";

std::string file_name(std::string_view id) { return data_file_name(kFolder, id); }

// Without an order a lesson comes after those that have one.
int order_of(const Json& json, std::string_view where) {
  return order_member(json, "order", std::numeric_limits<int>::max(), where);
}

// A file that cannot be read is the last one: it says why when it is opened.
int place_of(const std::string& id) {
  try {
    const Json json = parse_json(resource(file_name(id)), file_name(id));
    return order_of(json, file_name(id));
  } catch (const Error&) {
    return std::numeric_limits<int>::max();
  }
}

bool large_layout(const Json& node, std::string_view where) {
  const std::string layout = text_member(node, "layout", where);
  if (layout.empty() || layout == "mosaic") return false;
  if (layout == "large") return true;
  throw Error(ExitCode::bad_input, where, fmt::format("unknown layout '{}'", layout), "known: mosaic, large");
}

std::vector<std::string> names_member(const Json& node, const char* member, std::string_view where) {
  std::vector<std::string> names;
  if (!node.contains(member)) return names;
  if (!node[member].is_array())
    throw Error(ExitCode::bad_input, where,
                fmt::format("\"{}\" is {}, not an array of names", member, node[member].dump()));
  for (const Json& name : node[member]) {
    if (!name.is_string())
      throw Error(ExitCode::bad_input, where,
                  fmt::format("\"{}\" holds {}, not a name in quotes", member, name.dump()));
    names.push_back(name.get<std::string>());
  }
  return names;
}

double minutes_member(const Json& node, std::string_view where) {
  if (!node.contains("minutes")) return 1;
  const Json& minutes = node["minutes"];
  if (!minutes.is_number() || !(minutes.get<double>() > 0 && minutes.get<double>() <= 90))
    throw Error(ExitCode::bad_input, where,
                fmt::format("\"minutes\" is {}, not a number above 0 and up to 90", minutes.dump()));
  return minutes.get<double>();
}

LessonStep parse_step(const Json& node, std::string_view where) {
  only_members(node, {"say", "set", "view", "layout", "question", "answer", "minutes"}, where);
  LessonStep step;
  step.say = needed_text_member(node, "say", where);
  if (node.contains("set")) step.set = read_patch(node["set"], where);
  step.view = text_member(node, "view", where);
  if (!step.view.empty()) look_up(where, [&] { view_by_id(step.view); });
  step.large = large_layout(node, where);
  step.question = text_member(node, "question", where);
  step.answer = text_member(node, "answer", where);
  if (step.question.empty() != step.answer.empty())
    throw Error(ExitCode::bad_input, where, "\"question\" and \"answer\" must come together");
  step.minutes = minutes_member(node, where);
  return step;
}

}  // namespace

std::vector<std::string> lesson_ids() {
  std::vector<std::pair<int, std::string>> placed;
  for (const std::string& id : data_file_ids(kFolder)) placed.emplace_back(place_of(id), id);
  std::sort(placed.begin(), placed.end());
  std::vector<std::string> ids;
  for (auto& [place, id] : placed) ids.push_back(std::move(id));
  return ids;
}

Lesson load_lesson(const std::string& name) {
  const std::vector<std::string> ids = lesson_ids();
  if (std::find(ids.begin(), ids.end(), name) != ids.end()) return parse_lesson(name, resource(file_name(name)));
  if (const std::filesystem::path path = name; std::filesystem::is_regular_file(path))
    return parse_lesson(path.stem().string(), read_text_file(path), name);
  const std::vector<std::string_view> known(ids.begin(), ids.end());
  throw Error(ExitCode::bad_input, "lesson", fmt::format("unknown lesson '{}'", name), suggest(name, known));
}

LessonPlace load_lesson_place(const std::string& place) {
  const size_t colon = place.rfind(':');
  const auto step = colon == std::string::npos ? std::nullopt : whole_decimal(place.substr(colon + 1));
  if (!step) return {load_lesson(place)};
  Lesson lesson = load_lesson(place.substr(0, colon));
  const auto count = static_cast<long long>(lesson.steps.size());
  if (*step < 1 || *step > count)
    throw Error(ExitCode::bad_input, "lesson", fmt::format("'{}' has no step {}", lesson.id, *step),
                fmt::format("give 1 to {}", count));
  return {std::move(lesson), static_cast<size_t>(*step - 1)};
}

Lesson parse_lesson(std::string_view id, std::string_view json_text, std::string_view file) {
  const std::string where = file.empty() ? file_name(id) : std::string(file);
  const Json json = parse_json(json_text, where);
  if (!json.is_object()) throw Error(ExitCode::bad_input, where, "must be a JSON object");
  check_file_version(json, kLessonVersion, "lesson", where);  // first: a newer file's members would be called misspelt
  only_members(json, {"version", "order", "title", "preset", "exercises", "steps"}, where);
  order_of(json, where);

  Lesson lesson;
  lesson.id = id;
  lesson.title = needed_text_member(json, "title", where);
  lesson.preset = needed_text_member(json, "preset", where);
  Settings tried;
  look_up(where, [&] { tried = preset(lesson.preset).make(); });
  lesson.exercises = names_member(json, "exercises", where);
  if (!json.contains("steps") || !json["steps"].is_array() || json["steps"].empty())
    throw Error(ExitCode::bad_input, where, "\"steps\" must be an array of at least one step");
  for (const Json& node : json["steps"]) {
    const std::string here = fmt::format("{}: step {}", where, lesson.steps.size() + 1);
    lesson.steps.push_back(parse_step(node, here));
    apply_patch(tried, lesson.steps.back().set, here);  // in order, as it will be shown
  }
  return lesson;
}

Settings settings_at(const Lesson& lesson, size_t step) {
  assert(step < lesson.steps.size());
  Settings s = preset(lesson.preset).make();
  for (size_t i = 0; i <= step; ++i) apply_patch(s, lesson.steps[i].set, file_name(lesson.id));
  return s;
}

std::string view_at(const Lesson& lesson, size_t step) {
  for (size_t k = step + 1; k-- > 0;)
    if (!lesson.steps[k].view.empty()) return lesson.steps[k].view;
  return "final";
}

}  // namespace gbl
