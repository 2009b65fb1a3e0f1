#pragma once
// A G-buffer's packing as a drawing: one row per attachment, one cell per field, as wide as its bits.
#include <string>

#include "renderer/options/settings.h"

namespace gbl {

// SVG 1.1; the layout must be resolved.
std::string packing_svg(const Settings&, const std::string& title);

}  // namespace gbl
