#pragma once
// gnuplot as a function: script in, picture out.
#include <string>

namespace gbl {

// What gnuplot writes to its standard output. Error(unfinished) if it is not installed or refuses the script.
std::string drawn_by_gnuplot(const std::string& script);

}  // namespace gbl
