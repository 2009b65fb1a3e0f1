#pragma once
// Settings as JSON (nested by the dots of the paths, with "version") and patches by dotted path.
#include <filesystem>
#include <string_view>

#include "renderer/options/options.h"

namespace gbl {

Json to_json(const Settings&);
// Missing members keep `base`'s values; unknown ones, wrong types and newer versions are an Error naming `where`.
Settings from_json(const Json&, std::string_view where, Settings base = {});

// {"lights.cull": "none", "camera": {"fov": 60}}: dotted and nested forms may be mixed.
void apply_patch(Settings&, const Json& patch, std::string_view where);
// "lights.cull=none": the value is JSON if it parses as such, else a string.
void apply_assignment(Settings&, std::string_view assignment);

// A JSON file; Error with line and column if it cannot be read or parsed.
Json read_json(const std::filesystem::path&);
Json parse_json(std::string_view text, std::string_view where);

}  // namespace gbl
