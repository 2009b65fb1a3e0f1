#pragma once
// A layout of a user's own: one GLSL file with pack_material() and unpack_material(), as in shaders/layouts/. Its first
//
// line names its attachments in draw-buffer order, each with its format and what it holds (layout_header.h):
//   // attachments: material RGBA8 { rgb: albedo, sRGB-coded; a: roughness }
#include <string>
#include <string_view>

#include "renderer/gbuffer/layouts.h"

namespace gbl {

// Reads and checks the file: "PATH@HASH", by which settings name it from then on. Two files of one path are two layouts.
// Error(bad_input) with line and column. Somebody asks for it here, so what the path holds may run.
std::string name_layout_file(const std::string& path);
// The same for a path that a study, a lesson or another data file names.
std::string name_unasked_layout_file(const std::string& path);

// A layout is text for the GPU. What settings from elsewhere name does not run before somebody asks for its path.
void allow_layout_file(std::string_view path_or_name);
void allow_every_layout_file();
bool may_run_layout_file(std::string_view path_or_name);

bool names_content(std::string_view name);                    // is there a hash in it?
std::string_view path_of_layout_file(std::string_view name);  // without the hash

// What the file with this name and content says. Read once; good for as long as the program runs. Error(bad_input): it
// cannot be read, it is not the content that is named any more, or nobody asked for it.
const LayoutRow& layout_of_file(const std::string& name);
std::string shader_of_layout_file(const std::string& name);  // below shaders/, as shader_of(Layout)

}  // namespace gbl
