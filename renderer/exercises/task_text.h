#pragma once
// A task in words: what is asked, what there is to choose from, and how an answer is given and checked.
#include <string>

#include "renderer/exercises/exercise.h"

namespace gbl {

std::string task_text(const Exercise&);      // for a terminal
std::string task_markdown(const Exercise&);  // the same as a page
std::string bounds_text(const Exercise&);    // what a right answer holds, a line each; empty: nothing is bounded
std::string how_to_answer(const Exercise&);

}  // namespace gbl
