#pragma once
// The things that stand about in built-in scenes. Object space: Y up, feet at y = 0 or a little below, units of the
// terrain (a cow is 75 long). Painted things use the texture of make_paint(), stone ones any stone.
#include "renderer/scene/scene.h"

namespace gbl {

Mesh make_cow();        // looks along +X; hooves at y = 0
Mesh make_lamp_post();  // 130 high
Mesh make_arch();       // 150 high, 170 wide (along X), 40 deep; one walks through along Z
Mesh make_wall();       // an L of two low walls along -X and -Z from their common corner at the origin

}  // namespace gbl
