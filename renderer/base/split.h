#pragma once
#include <string_view>
#include <vector>

namespace gbl {

// The parts between every `at`, views into the text: at least one, some may be empty.
std::vector<std::string_view> split(std::string_view text, std::string_view at);

}  // namespace gbl
