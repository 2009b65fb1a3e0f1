// `exercise`: tasks with a state to begin with, answers that are measured, and a class's answers at once.
#include <fmt/format.h>
#include <unistd.h>

#include "app/commands.h"
#include "app/exercise_grade.h"
#include "app/headless.h"
#include "app/lab.h"
#include "app/picture_texts.h"
#include "app/truth_drawing.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/base/limits.h"
#include "renderer/exercises/task_text.h"
#include "renderer/options/settings_json.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

CheckWishes wishes_of(const Arguments& a) { return {a.limit_s.value_or(kAnswerSeconds), a.without, api_of(a)}; }

ExitCode list_exercises(const Arguments& a) {
  Json all = Json::array();
  for (const Exercise& e : load_exercises()) {
    if (a.json)
      all.push_back({{"id", e.id}, {"title", e.title}, {"answer", std::string(id_of(e.answer))}, {"source", e.source}});
    else
      fmt::print("{:<24} {:<9} {}\n", e.id, id_of(e.answer), e.title);
  }
  if (a.json) fmt::print("{}\n", all.dump(2));
  return ExitCode::done;
}

void write_pictures(const fs::path& folder, const Arguments& a, const Settings& s) {
  const HeadlessContext context(api_of(a));
  Lab lab(without_of(a));
  require_valid(s, lab.limits());
  lab.draw(s);
  std::vector<View> views = {View::final};
  if (const View main = view_by_id(s.view.main).view; main != View::final) views.push_back(main);
  for (const View v : views) {
    draw_any_view(lab, v, lab.is_main(v));
    write_png(folder / fmt::format("{}.png", row(v).id), lab.image_of(v),
              picture_texts(fmt::format("gbufferlab render --only {}", row(v).id), s, lab.machine()));
  }
}

// An answer that was begun stays as it is.
std::vector<fs::path> write_start(const fs::path& folder, const Exercise& e) {
  make_folder(folder);
  const fs::path state = folder / "state.json", answer = folder / fmt::format("{}.{}", e.id, ending_of(e));
  write_text_file(folder / "task.md", task_markdown(e));
  write_text_file(state, settings_text(state_of(e)) + "\n");
  if (!fs::exists(answer)) write_text_file(answer, template_of(e));
  return {state, answer};
}

ExitCode open_exercise(const Arguments& a, const Exercise& e) {
  const fs::path folder = a.output.value_or(fs::path("out/exercises") / e.id);
  const std::vector<fs::path> files = write_start(folder, e);
  const bool window = display_present() && !a.output;
  if (!window) write_pictures(folder, a, state_of(e));
  if (a.json)
    fmt::print("{}\n", Json{{"id", e.id},
                            {"title", e.title},
                            {"task", e.task},
                            {"state", files[0].string()},
                            {"answer", files[1].string()}}
                           .dump(2));
  else
    fmt::print("{}\nThe state, the answer's file{} and the task are in {}\n", task_text(e), window ? "" : ", pictures",
               folder.string());
  if (!window) return ExitCode::done;
  flush_output();
  Arguments view = a;
  view.command = "view", view.state = files[0].string(), view.fresh = true, view.json = false;
  return run_view(view);
}

ExitCode check(const Arguments& a, const Exercise& e) {
  const std::string file = a.check.value().string();
  const ExerciseVerdict v = a.here ? check_here(e, file, wishes_of(a)) : check_answer(e, file, wishes_of(a));
  if (a.json) {
    fmt::print("{}\n", to_json(v).dump(2));
  } else {
    fmt::print("{}: {}\n", e.id, v.right ? "right" : "wrong");
    if (!v.measured.empty()) fmt::print("  measured: {}\n", v.measured);
    if (!v.off.empty()) fmt::print("  off: {}\n", v.off);
    if (!v.hint.empty()) fmt::print("  hint: {}\n", v.hint);
  }
  return v.right ? ExitCode::done : ExitCode::check_failed;
}

void print(const GradeRow& r, bool csv) {
  if (csv)
    fmt::print("{}", csv_line(r));
  else
    fmt::print("{:<16} {:<24} {:<6} {}\n", r.student, r.exercise, r.right ? "right" : "wrong", r.note);
  flush_output();  // whoever stops it keeps what is done
}

Json json_of(const GradeRow& r) {
  return {
      {"student", r.student}, {"exercise", r.exercise}, {"right", r.right}, {"measure", r.measure}, {"note", r.note}};
}

ExitCode grade_class(const Arguments& a) {
  const std::vector<GradeFile> files = answers_in(*a.grade);
  if (files.empty())
    throw Error(ExitCode::bad_input, a.grade->string(), "holds no answers",
                "name them STUDENT/EXERCISE.json or STUDENT-EXERCISE.json");
  if (a.csv) fmt::print("{}", kGradeHeader);
  Json all = Json::array();
  const bool terminal = isatty(STDERR_FILENO);
  for (size_t i = 0; i < files.size(); ++i) {
    const GradeFile& f = files[i];
    if (terminal) fmt::print(stderr, "\r\033[K{} of {}: {} {}", i + 1, files.size(), f.student, f.exercise);
    const GradeRow row = grade(f, wishes_of(a));
    if (terminal) fmt::print(stderr, "\r\033[K");
    if (a.json)
      all.push_back(json_of(row));
    else
      print(row, a.csv);
  }
  if (a.json) fmt::print("{}\n", all.dump(2));
  return ExitCode::done;
}

}  // namespace

ExitCode run_exercise(const Arguments& a) {
  if (a.grade) return grade_class(a);
  if (a.limit_s && !a.check)
    throw Error(ExitCode::bad_input, "--limit", "limits nothing here", "give it with --check or --grade");
  if (a.what.empty()) {
    if (a.check) throw Error(ExitCode::bad_input, "--check", "names no exercise", "write exercise NAME --check FILE");
    if (a.output) throw Error(ExitCode::bad_input, "-o", "names no exercise", "write exercise NAME -o DIR");
    return list_exercises(a);
  }
  const Exercise e = load_exercise(a.what);
  return a.check ? check(a, e) : open_exercise(a, e);
}

}  // namespace gbl
