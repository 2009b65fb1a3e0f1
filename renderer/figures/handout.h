#pragma once
// A lesson on paper: for those who hear it, and for the one who gives it. Written from the lesson's own data.
#include <string>
#include <vector>

#include "renderer/figures/captions.h"
#include "renderer/lessons/lessons.h"

namespace gbl {

// A step's picture in the document.
struct HandoutFigure {
  FigureWords words;
  std::string look_at;  // the views in it, a sentence each
  std::string png;      // its bytes, for the page that holds its pictures itself
};

// Both: the steps with their figures, what to look at, the command that opens this state, questions with room to write; the answers
// on the last page. One figure a step.
std::string handout_markdown(const Lesson&, const std::vector<HandoutFigure>&);
std::string handout_html(const Lesson&, const std::vector<HandoutFigure>&);  // A4, without a network, without scripts

// What to press, what to say, and how long it takes: Markdown. No pictures are needed.
// name: how the lesson is asked for, by its id or its file.
std::string lecture_script(const Lesson&, const std::string& name);

}  // namespace gbl
