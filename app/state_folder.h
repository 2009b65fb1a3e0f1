#pragma once
// Where this program keeps what it remembers: the XDG base directories.
#include <filesystem>
#include <optional>

namespace gbl {

// $XDG_STATE_HOME/gbufferlab, or ~/.local/state/gbufferlab; it need not be there. Empty: the environment names no folder.
std::optional<std::filesystem::path> state_folder();

// With its parents and the rights that the XDG base directories ask for; Error(unfinished).
void make_private_folder(const std::filesystem::path&);

}  // namespace gbl
