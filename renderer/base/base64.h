#pragma once
// RFC 4648, section 4, with padding.
#include <string>
#include <string_view>

namespace gbl {

std::string base64(std::string_view bytes);

}  // namespace gbl
