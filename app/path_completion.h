#pragma once
// What a path that is being typed can become.
#include <string>

#include "ui/path_io.h"

namespace gbl {

std::string at_home(const std::string& path);  // "~/models" -> "/home/NAME/models"

// All but the recent files.
ui::PathInput completions(const std::string& typed);

}  // namespace gbl
