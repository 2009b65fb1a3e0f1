#pragma once
// What a picture says of itself, in text chunks: what made it, and how to make it again.
#include <string>

#include "app/commands.h"
#include "renderer/picture/image.h"
#include "renderer/study/rows/study_columns.h"

namespace gbl {

inline constexpr const char* kVersionKey = "gbufferlab-version";  // and a hash of the shaders
inline constexpr const char* kDriverKey = "gbufferlab-driver";
inline constexpr const char* kCommandKey = "gbufferlab-command";

std::string shell_quoted(const std::string& word);  // as one word of a shell's line

// The line for a shell that draws these settings: the command's words, then an option for each value that is not as
// loaded. Whatever preset, state or scene they came from is not needed any more, but for the files of models and rigs.
std::string command_line(const std::string& command, const Settings&);

PngText picture_texts(const std::string& command, const Settings&, const Machine&);

}  // namespace gbl
