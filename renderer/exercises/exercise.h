#pragma once
// Exercises as data: assets/exercises/<id>.json, one file each. docs/exercises.md says how to write one.
//   {"version": 1, "order": 1, "title": "…", "source": "…", "task": "…", "hint": "…", "tolerance": "why the bounds are as they are",
//    "preset": "start", "set": {…}, "answer": "choice" | "number" | "pixel" | "settings" | "glsl" | "layout",
//    "choices": [{"id": "…", "text": "…", "set": {…}}], "start": ["a line of the answer's file", …], "check": {…}}
// "check" says what a right answer has, never which one it is: bounds of measured numbers, a measure of which the right
// choice has least, the error of a function against the reference; or a salted hash, where nothing can be measured.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/options/options.h"

namespace gbl {

enum class AnswerKind { choice, number, pixel, settings, glsl, layout };

struct ExerciseChoice {
  std::string id, text;
  std::vector<Assignment> set;  // what it means for the state
};

// A measured number that a right answer keeps within.
struct ExerciseBound {
  std::string measure;  // exercise_measures.h; of a pixel pixel_measures()
  std::optional<double> at_least, at_most;
  std::string hint;  // where this one fails; empty: the exercise's
};

// A function of the student's, called once for each of a list of inputs.
struct GlslCheck {
  std::string call;      // in terms of the inputs vec4 a and b, e.g. "vec4(decode(a.xy), 0.0)"
  std::string inputs;    // glsl_tasks.h
  std::string expected;  // … or "input": a comes back, as from a round trip
  std::string error;     // "angle" in degrees, "relative" or "absolute"
  double at_most = 0;
};

struct Exercise {
  std::string id;  // file name without ending
  int order = 0;
  std::string title, source, task, hint, tolerance;
  AnswerKind answer{};
  std::string preset;
  std::vector<Assignment> set;    // over the preset: the state that opens
  std::vector<Assignment> truth;  // over the answer's settings: whose reference judges it
  std::vector<ExerciseBound> bounds;
  std::vector<ExerciseChoice> choices;
  std::string least;              // of a choice: among those within all bounds the right one has least of this measure
  std::string salt, hash;         // of a choice where nothing is measured: see hash_of_choice()
  std::string measure;            // of a number: what is asked for, …
  std::vector<Assignment> over;   // … or, with these, how many times as large it is with them as without
  double relative = 0;            // how far off a number may be, as a share of it
  std::vector<std::string> free;  // of settings: the paths that may be changed; "lights.*" means all of a group
  GlslCheck glsl;
  std::vector<std::string> start;  // lines of the file that a student begins with
};

std::string_view id_of(AnswerKind);

std::vector<Exercise> load_exercises();       // by their order, then by name; Error of the first that cannot be read
Exercise load_exercise(std::string_view id);  // Error with the nearest
Exercise parse_exercise(std::string_view id, std::string_view json_text);
std::vector<std::string> exercise_ids();

Settings state_of(const Exercise&);  // what opens

// So that an answer is not read beside its task: SHA-256 of salt, exercise and choice.
std::string hash_of_choice(const Exercise&, std::string_view choice);

}  // namespace gbl
