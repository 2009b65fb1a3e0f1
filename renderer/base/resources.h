#pragma once
// Shaders and assets by name ("shaders/combine.frag", "assets/lessons/…"): embedded at build; the source folder,
// when it is there, overrides and can be watched.
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gbl {

std::string resource(std::string_view name);  // Error if there is none of that name
std::string_view embedded_bytes(std::string_view name);
// A text that comes from elsewhere: `resource` gives it under this name from now on, and messages call it `shown`.
void lend_resource(const std::string& name, std::string text, std::string shown);
std::string shown_name(const std::string& name);                   // of a lent one; else the name itself
std::vector<std::string> resource_names(std::string_view prefix);  // sorted

// Folder whose files override the embedded ones (default: the source folder if it exists). Empty = none.
void set_override_folder(std::filesystem::path);
std::filesystem::path override_folder();

// Newest change below the override folder's shaders/; changes when a file is saved. 0 without a folder.
long long shaders_stamp();

}  // namespace gbl
