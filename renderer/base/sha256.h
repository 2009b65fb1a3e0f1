#pragma once
// A text's fingerprint: FIPS 180-4, "Secure Hash Standard".
#include <string>
#include <string_view>

namespace gbl {

std::string sha256(std::string_view bytes);  // 64 hexadecimal digits, lower case

}  // namespace gbl
