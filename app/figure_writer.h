#pragma once
// A figure's files: its picture, and its words for those who print it. F12 and the commands write them alike.
#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/figure_maker.h"
#include "renderer/figures/captions.h"

namespace gbl {

// FOLDER/ID.md and FOLDER/ID.tex.
void write_words(const std::filesystem::path& folder, const FigureWords&);

struct FigureOptions {
  FigureLook look;
  std::string set;       // as it was asked for: for the command in the picture
  bool numbers = false;  // also ID.exr
  bool few_colours = false, pictures_only = false;
  std::string without = {};                        // features that are switched off
  const std::atomic<bool>* interrupted = nullptr;  // ends a film early
};

// Makes it, and writes it to FOLDER as ID.png or ID.svg with its words; with frames as ID/0001.png … and, where ImageMagick is
// installed, as ID.gif.
// Empty: a film was interrupted; its pictures so far stay.
std::optional<FigureWords> write_figure(const std::filesystem::path& folder, const FigureSpec&, FigureMaker&,
                                        const Machine&, const FigureOptions&);

// "gbufferlab figures SET --only ID …": makes this figure again.
std::string figure_command(const FigureSpec&, const FigureOptions&);

// captions.json: the words of all figures of a folder; of those that are not made now, the ones that were there.
void write_captions(const std::filesystem::path& folder, const std::string& title, const std::vector<FigureWords>&);

// Empty: the figure's file in this folder shows what the figure shows now. Else which file, and what is wrong.
std::string why_outdated(const std::filesystem::path& folder, const FigureSpec&, FigureMaker&);

}  // namespace gbl
