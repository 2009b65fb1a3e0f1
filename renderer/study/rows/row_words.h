#pragma once
// Rows in words, as the window's column of controls calls things.
#include <string>

#include "renderer/study/rows/study_row.h"

namespace gbl {

std::string coordinate_words(const std::string& path, const OptionValue&);  // "Method: Tiled, 16x16 px"
std::string row_words(const StudyRow&);  // what the study varies, here, joined by dots in the middle; "" = nothing

// A noisy time: "noisy: 12.1 to 40.3 ms". No number that could be taken for the time.
std::string noisy_words(const StudyRow&, const StudyColumn&);

// The failures that these settings are known for, joined by commas; "" = sound.
std::string unsound_words(const Settings&);

}  // namespace gbl
