#pragma once
// Settings as JSON (nested by the dots of the paths, with "version") and patches by dotted path: the one place where
// an option's value becomes JSON and JSON becomes a value.
#include <filesystem>
#include <string_view>

#include "renderer/base/json_fwd.h"
#include "renderer/options/options.h"

namespace gbl {

Json to_json(const Settings&);
// Missing members keep `base`'s values; unknown ones, wrong types and newer versions are an Error naming `where`.
Settings from_json(const Json&, std::string_view where, Settings base = {});

// The same as text, indented: what files and pictures hold.
std::string settings_text(const Settings&);
// On one line, what differs from the defaults alone: what a link holds. parse_settings() reads both.
std::string settings_link(const Settings&);
Settings parse_settings(std::string_view text, std::string_view where);
Settings read_settings(const std::filesystem::path&);

Json to_json(const OptionValue&);       // not of what is Unfit
OptionValue option_value(const Json&);  // any JSON: what no option takes is Unfit

// {"lights.cull": "none", "camera": {"fov": 60}}: dotted and nested forms may be mixed.
std::vector<Assignment> read_patch(const Json&, std::string_view where);
std::vector<Assignment> parse_patch(std::string_view text, std::string_view where);
// A value as one types it: JSON if it parses as such, else the text itself.
OptionValue parse_value(std::string_view text, std::string_view where);
void apply_assignment(Settings&, std::string_view assignment);  // "lights.cull=none"

// A JSON file; Error with line and column if it cannot be read or parsed.
Json read_json(const std::filesystem::path&);
Json parse_json(std::string_view text, std::string_view where);

}  // namespace gbl
