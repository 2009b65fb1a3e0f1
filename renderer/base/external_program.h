#pragma once
// Programs that are used where they are installed.
#include <string>
#include <vector>

namespace gbl {

// False: it is not installed. What it prints goes to our standard error. Error(unfinished) if it fails.
bool run_program_if_there(const std::string& name, std::vector<std::string> arguments);

}  // namespace gbl
