#pragma once
// Mistakes of our own code that GL passes over in silence and that need not stop a picture: a uniform that no shader
// has, an error that nobody asked for. Debug builds print each on stderr; every GL test fails by them.
#include <string>
#include <vector>

namespace gbl::gl {

#ifdef NDEBUG
inline constexpr bool kReportsMisuse = false;
#else
inline constexpr bool kReportsMisuse = true;
#endif

void report_misuse(std::string what);    // nothing without kReportsMisuse
std::vector<std::string> take_misuse();  // what was reported since the last call
}  // namespace gbl::gl
