#pragma once
// A figure's words, for Markdown, for LaTeX and for those who do not see it.
#include <string>
#include <string_view>

#include "renderer/figures/figure_spec.h"

namespace gbl {

std::string latex_escaped(std::string_view);     // of text: what LaTeX would read as its own is written out
std::string markdown_escaped(std::string_view);  // within a line

// What a figure in a document needs to say.
struct FigureWords {
  std::string id, file;             // "lost-light", "lost-light.png"
  std::string on_paper = {};        // the file for LaTeX, where that is another one: of a film its first picture
  std::string title, caption, alt;  // sentences
  std::string source;               // what it shows the figure of; may be empty
  std::string command, made_by;     // for a shell; version and driver
  double width_cm = 0;              // as printed; 0: not known
};

// "(a) broken. (b) fixed." of its panels; empty where nothing is said of them.
std::string panel_words(const FigureSpec&);
// The spec's own, or else its title and what each panel shows.
std::string alt_text(const FigureSpec&);

std::string markdown_caption(const FigureWords&);  // picture, caption, command
std::string latex_caption(
    const FigureWords&);  // a figure environment with \label{fig:ID}; packages: graphicx of 2021-11 or later
Json caption_json(const FigureWords&);

}  // namespace gbl
