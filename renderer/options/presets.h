#pragma once
// Presets: whole settings by name, scene and camera included. One row each.
#include <span>
#include <string_view>

#include "renderer/options/settings.h"

namespace gbl {

struct Preset {
  const char* id;
  const char* label;
  const char* help;    // one line: what it is and whose
  Settings (*make)();  // every setting, nothing left to a default of another place
};

std::span<const Preset> presets();
const Preset& preset(std::string_view id);  // Error with the known ones

// The preset whose settings these are but for size, time and view; null if none.
const Preset* preset_of(const Settings&);

}  // namespace gbl
