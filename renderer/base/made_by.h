#pragma once
// Which program measured something: a number of another version, or of other shaders, is another measurement.
#include <cstdint>
#include <string>
#include <string_view>

namespace gbl {

// "0.3.0 5f2a91c477e01b36": the version, and a hash of all shaders as they are read now.
std::string made_by();

uint64_t fnv1a(std::string_view text);  // Fowler, Noll and Vo: FNV-1a, 64 bits

}  // namespace gbl
