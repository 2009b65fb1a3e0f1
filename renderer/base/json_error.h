#pragma once
// What the JSON library says of an error, as a person would.
#include <algorithm>
#include <string_view>

namespace gbl {

// "[json.exception.type_error.302] type must be …" without its first word.
inline std::string_view without_library(std::string_view what) {
  if (what.starts_with('[')) what.remove_prefix(std::min(what.find("] ") + 2, what.size()));
  return what;
}

}  // namespace gbl
