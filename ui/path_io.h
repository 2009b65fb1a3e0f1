#pragma once
// What the panel of the path and the app tell each other: the files are the app's.
#include <string>
#include <vector>

namespace gbl::ui {

struct PathInput {
  std::string asked;                 // the text that this answers
  std::vector<std::string> matches;  // names in its folder that begin as it ends and can be opened; folders end in /
  std::string completed;             // the text with all that the matches have in common
  bool folder = false;               // the text names one
  std::string note;                  // why its folder cannot be read; empty = it can
  std::vector<std::string> recent;   // files, the newest first
};

struct PathRequest {
  bool open = false;  // the panel is
  std::string typed;  // to be completed
  std::string file;   // to be opened; empty = none
};

}  // namespace gbl::ui
