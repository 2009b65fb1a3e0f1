// Exercises in the page: a task for its reader, and an answer that is judged between two frames. exercises.js asks.
#include <emscripten.h>
#include <functional>
#include <string>

#include "app/exercise_bench.h"
#include "app/exercise_check.h"
#include "renderer/base/json.h"
#include "renderer/exercises/task_text.h"
#include "renderer/options/settings_json.h"

namespace gbl {
namespace {

// As JSON, for the page; it stays until the next one. What is wrong is {"error": …}.
const char* said(const std::function<Json()>& make) {
  static std::string text;
  try {
    text = make().dump();
  } catch (const std::exception& e) {
    text = Json{{"error", e.what()}}.dump();
  }
  return text.c_str();
}

Json names() {
  Json all = Json::array();
  for (const Exercise& e : load_exercises()) all.push_back({{"id", e.id}, {"title", e.title}});
  return all;
}

Json task_of(const Exercise& e) {
  Json choices = Json::array();
  for (const ExerciseChoice& c : e.choices) choices.push_back({{"id", c.id}, {"text", c.text}});
  const Settings state = state_of(e);
  return {{"id", e.id},
          {"title", e.title},
          {"source", e.source},
          {"task", e.task},
          {"choices", choices},
          {"holds", bounds_text(e)},
          {"tolerance", e.tolerance},
          {"how", how_to_answer(e)},
          {"kind", std::string(id_of(e.answer))},
          {"begin", template_of(e)},
          {"file", e.id + "." + ending_of(e)},
          {"size", {state.size.x, state.size.y}},
          {"state", settings_link(state)}};
}

Json judged(const Exercise& e, const char* file) {
  const Answer answer = read_answer(e, file);
  return to_json(needs_gl(e) ? ExerciseBench({}).judge(e, answer) : judge_answer(e, answer, {}));
}

}  // namespace
}  // namespace gbl

extern "C" {
EMSCRIPTEN_KEEPALIVE const char* page_exercises() { return gbl::said(gbl::names); }
EMSCRIPTEN_KEEPALIVE const char* page_task(const char* id) {
  return gbl::said([&] { return gbl::task_of(gbl::load_exercise(id)); });
}
EMSCRIPTEN_KEEPALIVE const char* page_judge(const char* id, const char* file) {
  return gbl::said([&] { return gbl::judged(gbl::load_exercise(id), file); });
}
}
