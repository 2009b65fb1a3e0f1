#pragma once
// OpenEXR takes memory for what an attribute claims before it reads it, and goes on where it has read to rather than where the
// attribute ends. So headers are looked through before it sees them.
#include <cstddef>
#include <string>
#include <string_view>

namespace gbl {

// start: of the file, its header and more. Error(bad_input), named after `where`: an attribute is longer than the file, or not as
// long as its type. ("OpenEXR File Layout", openexr.com: eight bytes, then name, type, length and bytes of each attribute.)
void require_sound_exr_header(std::string_view start, size_t file_bytes, const std::string& where);

}  // namespace gbl
