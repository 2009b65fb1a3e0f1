#pragma once
// The manual of an installed program: a man page and bash's completions, from the grammar of the command line and the tables.
#include <filesystem>
#include <string>

namespace gbl {

std::string man_page();                                  // roff, for man(7)
std::string bash_completion();                           // for share/bash-completion/completions
void write_manual(const std::filesystem::path& folder);  // gbufferlab.1 and gbufferlab; made if need be

}  // namespace gbl
