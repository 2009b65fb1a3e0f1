#pragma once
// The five sources' set-ups, as they are printed and with their mistakes fixed and nothing else changed.
#include "renderer/options/settings.h"

namespace gbl {

Settings nclgl();
Settings nclgl_fixed();
Settings stereo();
Settings stereo_fixed();
Settings learnopengl_a();  // every light on every pixel
Settings learnopengl_b();  // with a falloff and a distance test
Settings learnopengl();    // with light volumes
Settings learnopengl_fixed();
Settings objectid();
Settings objectid_fixed();
Settings viewspace();
Settings viewspace_fixed();

}  // namespace gbl
