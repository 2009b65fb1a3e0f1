#include "renderer/exercises/exercise.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

#include "renderer/base/json.h"
#include "renderer/base/resources.h"
#include "renderer/base/sha256.h"
#include "renderer/exercises/exercise_measures.h"
#include "renderer/exercises/glsl_tasks.h"
#include "renderer/options/data_file.h"
#include "renderer/options/presets.h"
#include "renderer/options/settings_json.h"

namespace gbl {
namespace {

constexpr int kVersion = 1;
constexpr std::string_view kFolder = "assets/exercises/";
constexpr std::string_view kKinds[] = {"choice", "number", "pixel", "settings", "glsl", "layout"};  // AnswerKind

std::string file_name(std::string_view id) { return data_file_name(kFolder, id); }

template <size_t kCount>
size_t known_word(const Json& node, const char* member, const std::string_view (&known)[kCount],
                  const std::string& where) {
  const std::string word = needed_text_member(node, member, where);
  const auto* const found = std::find(std::begin(known), std::end(known), word);
  if (found == std::end(known))
    throw Error(ExitCode::bad_input, where, fmt::format("unknown {} '{}'", member, word), suggest(word, known, kCount));
  return static_cast<size_t>(found - std::begin(known));
}

std::optional<double> number(const Json& node, const char* member, const std::string& where) {
  if (!node.contains(member)) return {};
  if (!node[member].is_number())
    throw Error(ExitCode::bad_input, where, fmt::format("\"{}\" must be a number", member));
  return node[member].get<double>();
}

double needed_number(const Json& node, const char* member, const std::string& where) {
  const std::optional<double> n = number(node, member, where);
  if (!n) throw Error(ExitCode::bad_input, where, fmt::format("\"{}\" is missing", member));
  return *n;
}

std::vector<Assignment> patch(const Json& node, const char* member, const std::string& where) {
  return node.contains(member) ? read_patch(node[member], where) : std::vector<Assignment>{};
}

const Json& needed_array(const Json& node, const char* member, const std::string& where) {
  if (!node.contains(member) || !node[member].is_array() || node[member].empty())
    throw Error(ExitCode::bad_input, where, fmt::format("\"{}\" must be an array that is not empty", member));
  return node[member];
}

std::vector<std::string> texts(const Json& node, const char* member, const std::string& where) {
  std::vector<std::string> out;
  if (!node.contains(member)) return out;
  for (const Json& text : needed_array(node, member, where)) {
    if (!text.is_string()) throw Error(ExitCode::bad_input, where, fmt::format("\"{}\" must hold texts", member));
    out.push_back(text.get<std::string>());
  }
  return out;
}

ExerciseBound bound_of(const Json& node, bool of_pixel, const std::string& where) {
  only_members(node, {"measure", "at_least", "at_most", "hint"}, where);
  ExerciseBound b;
  b.measure = needed_text_member(node, "measure", where);
  look_up(where, [&] { of_pixel ? (void)pixel_measure(b.measure) : (void)exercise_measure(b.measure); });
  b.at_least = number(node, "at_least", where), b.at_most = number(node, "at_most", where);
  if (!b.at_least && !b.at_most) throw Error(ExitCode::bad_input, where, "a bound needs \"at_least\" or \"at_most\"");
  b.hint = text_member(node, "hint", where);
  return b;
}

void read_bounds(Exercise& e, const Json& check, const std::string& where) {
  for (const Json& node : needed_array(check, "bounds", where))
    e.bounds.push_back(bound_of(node, e.answer == AnswerKind::pixel, where));
}

void read_choices(Exercise& e, const Json& json, const std::string& where) {
  for (const Json& node : needed_array(json, "choices", where)) {
    only_members(node, {"id", "text", "set"}, where);
    e.choices.push_back(
        {needed_text_member(node, "id", where), needed_text_member(node, "text", where), patch(node, "set", where)});
  }
}

void read_choice_check(Exercise& e, const Json& check, const std::string& where) {
  if (check.contains("hash")) {
    only_members(check, {"salt", "hash"}, where);
    e.salt = needed_text_member(check, "salt", where), e.hash = needed_text_member(check, "hash", where);
    return;
  }
  only_members(check, {"bounds", "least"}, where);
  if (check.contains("bounds")) read_bounds(e, check, where);
  e.least = needed_text_member(check, "least", where);
  look_up(where, [&] { exercise_measure(e.least); });
}

void read_glsl_check(Exercise& e, const Json& check, const std::string& where) {
  only_members(check, {"call", "inputs", "expected", "error", "at_most"}, where);
  e.glsl = {needed_text_member(check, "call", where), needed_text_member(check, "inputs", where),
            needed_text_member(check, "expected", where), needed_text_member(check, "error", where),
            needed_number(check, "at_most", where)};
  look_up(where, [&] { require_known(e.glsl); });
}

void read_check(Exercise& e, const Json& json, const std::string& file) {
  const std::string where = file + ": check";
  if (!json.contains("check")) throw Error(ExitCode::bad_input, file, "\"check\" is missing");
  const Json& check = json["check"];
  switch (e.answer) {
    case AnswerKind::choice: return read_choice_check(e, check, where);
    case AnswerKind::number:
      only_members(check, {"measure", "over", "relative"}, where);
      e.measure = needed_text_member(check, "measure", where);
      look_up(where, [&] { exercise_measure(e.measure); });
      e.over = patch(check, "over", where), e.relative = needed_number(check, "relative", where);
      return;
    case AnswerKind::settings:
      only_members(check, {"bounds", "free"}, where);
      e.free = texts(check, "free", where);
      return read_bounds(e, check, where);
    case AnswerKind::pixel:
    case AnswerKind::layout: only_members(check, {"bounds"}, where); return read_bounds(e, check, where);
    case AnswerKind::glsl: return read_glsl_check(e, check, where);
  }
}

// Tried now, not when a student opens it.
void try_settings(const Exercise& e, const std::string& where) {
  look_up(where, [&] {
    const Settings start = state_of(e);
    const auto tried = [&](const std::vector<Assignment>& set) {
      Settings s = start;
      apply_patch(s, set, where);
    };
    tried(e.truth), tried(e.over);
    for (const ExerciseChoice& c : e.choices) tried(c.set);
  });
}

}  // namespace

std::string_view id_of(AnswerKind kind) { return kKinds[static_cast<size_t>(kind)]; }

std::vector<std::string> exercise_ids() { return data_file_ids(kFolder); }

Exercise parse_exercise(std::string_view id, std::string_view json_text) {
  const std::string where = file_name(id);
  const Json json = parse_json(json_text, where);
  if (!json.is_object()) throw Error(ExitCode::bad_input, where, "must be a JSON object");
  check_file_version(json, kVersion, "exercise", where);
  only_members(json,
               {"version", "order", "title", "source", "task", "hint", "tolerance", "preset", "set", "truth", "answer",
                "choices", "start", "check"},
               where);
  Exercise e;
  e.id = id;
  const auto text = [&](const char* member) { return needed_text_member(json, member, where); };
  e.order = order_member(json, "order", std::numeric_limits<int>::max(), where);
  e.title = text("title"), e.source = text("source"), e.task = text("task"), e.hint = text("hint");
  e.tolerance = text("tolerance"), e.preset = text("preset");
  e.answer = static_cast<AnswerKind>(known_word(json, "answer", kKinds, where));
  e.set = patch(json, "set", where), e.truth = patch(json, "truth", where), e.start = texts(json, "start", where);
  if (e.answer == AnswerKind::choice) read_choices(e, json, where);
  read_check(e, json, where);
  try_settings(e, where);
  return e;
}

std::vector<Exercise> load_exercises() {
  std::vector<Exercise> all;
  for (const std::string& id : exercise_ids()) all.push_back(parse_exercise(id, resource(file_name(id))));
  std::stable_sort(all.begin(), all.end(), [](const Exercise& a, const Exercise& b) { return a.order < b.order; });
  return all;
}

Exercise load_exercise(std::string_view id) {
  const std::vector<std::string> ids = exercise_ids();
  if (std::find(ids.begin(), ids.end(), id) == ids.end()) {
    const std::vector<std::string_view> known(ids.begin(), ids.end());
    throw Error(ExitCode::bad_input, "exercise", fmt::format("unknown exercise '{}'", id), suggest(id, known));
  }
  return parse_exercise(id, resource(file_name(id)));
}

Settings state_of(const Exercise& e) {
  Settings s = preset(e.preset).make();
  apply_patch(s, e.set, file_name(e.id));
  return s;
}

std::string hash_of_choice(const Exercise& e, std::string_view choice) {
  return sha256(fmt::format("{}/{}/{}", e.salt, e.id, choice));
}

}  // namespace gbl
