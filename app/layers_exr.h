#pragma once
// The numbers of views as one EXR file, for tev, HDRView, Blender and scripts.
#include <filesystem>

#include "app/lab.h"
#include "renderer/picture/image.h"

namespace gbl {

// R, G, B: lit; A: 1 where a surface is; Z: distance along the view axis; and <view>.<channel> of each view. The texts
// become attributes.
void write_layers(const std::filesystem::path&, Lab&, const std::vector<View>&, const PngText&);

}  // namespace gbl
