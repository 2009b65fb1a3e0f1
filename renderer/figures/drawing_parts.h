#pragma once
// The drawings of drawings.cpp, one function each: SVG of settings.
#include <string>

#include "renderer/options/settings.h"

namespace gbl {

std::string draw_falloff(const Settings&, const std::string& title);
std::string draw_disc(const Settings&, const std::string& title);
std::string draw_light_from_side(const Settings&, const std::string& title);

}  // namespace gbl
