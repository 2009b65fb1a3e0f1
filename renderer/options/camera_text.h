#pragma once
// A camera in one line, as command lines and figures write it.
#include <string>
#include <string_view>

#include "renderer/options/settings.h"

namespace gbl {

// "x,y,z:yaw,pitch[:fov]" in world units and degrees (vertical); a perspective camera. Without a fov it keeps its own, with one
// also its shape follows the picture's. Error(bad_input) beginning with `where`.
void apply_camera(Settings&, const std::string& text, std::string_view where);

}  // namespace gbl
