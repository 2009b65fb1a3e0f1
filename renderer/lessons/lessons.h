#pragma once
// Lessons: data (assets/lessons/*.json) that the window steps through and that scripts and handouts are printed from.
//   {"version": 1, "order": 2, "title": "…", "preset": "start", "exercises": ["…"], "steps": [{"say": "…", "set": {"lights.cull": "back"},
//    "view": "final", "layout": "mosaic" | "large", "question": "…", "answer": "…", "minutes": 1}]}
// A step's settings are the preset's with the patches of steps 0…k applied in order: a step is a pure function of
// the file, so stepping back gives exactly what was seen.
#include <string>
#include <string_view>
#include <vector>

#include "renderer/options/options.h"

namespace gbl {

struct LessonStep {
  std::string say;              // one or two sentences, shown large
  std::vector<Assignment> set;  // may be empty
  std::string view;             // view id shown large or marked; empty = as before
  bool large = false;           // the view alone, else the mosaic
  std::string question;         // may be empty
  std::string answer;           // revealed by Enter
  double minutes = 1;           // that a lecturer spends on it
};

struct Lesson {
  std::string id;  // file name without ending
  std::string title;
  std::string preset;
  std::vector<LessonStep> steps;
  std::vector<std::string> exercises;  // that go with it, by name; may be empty
};

std::vector<std::string> lesson_ids();  // as they are taught: by their "order", then by name
// One of these, or else a file. Error with the known ones; every step's patch has been tried.
Lesson load_lesson(const std::string& id_or_file);
// The same, and where it is opened: "NAME:3" is its third step, "NAME" its first.
struct LessonPlace {
  Lesson lesson;
  size_t step = 0;
};
LessonPlace load_lesson_place(const std::string& place);
Lesson parse_lesson(std::string_view id, std::string_view json_text,
                    std::string_view where = {});  // where: for messages

Settings settings_at(const Lesson&, size_t step);
std::string view_at(const Lesson&, size_t step);  // its own, or that of a step before

}  // namespace gbl
