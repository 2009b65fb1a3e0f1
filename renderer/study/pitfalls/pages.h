#pragma once
// The catalogue as Markdown: a page for each entry, and an index with its pictures, the set for a lecture first.
#include <string>
#include <vector>

#include "renderer/study/pitfalls/judge.h"

namespace gbl {

struct JudgedPitfall {
  PitfallEntry entry;
  PitfallResult result;
};

// <id>.md, beside <id>.png: broken, fixed, and their difference, whose brightest colour stands for so many codes of 255.
std::string pitfall_page(const JudgedPitfall&, double most_codes, glm::ivec2 size, const PitfallBounds&,
                         const std::string& device);

// README.md, of all entries.
std::string pitfall_index(const std::vector<JudgedPitfall>&, glm::ivec2 size, const std::string& device);

}  // namespace gbl
