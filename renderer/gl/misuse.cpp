#include "renderer/gl/misuse.h"

#include <cstdio>
#include <fmt/format.h>
#include <utility>

namespace gbl::gl {
namespace {
std::vector<std::string> g_reported;  // one GL thread
}

void report_misuse(std::string what) {
  if (!kReportsMisuse) return;
  fmt::print(stderr, "gl: {}\n", what);
  g_reported.push_back(std::move(what));
}

std::vector<std::string> take_misuse() { return std::exchange(g_reported, {}); }

}  // namespace gbl::gl
