#pragma once
// The camera that shows a whole scene.
#include "renderer/scene/scene.h"

namespace gbl {

// Looking along `camera`, with its lens: moved to where the scene fills `part` (0..1) of the picture's shorter side and
// stands in its middle, whatever the picture's shape. Near and far leave room to walk in and to step back.
// scene.bounds must be known.
Camera framed(const Scene&, Camera camera, double part);

}  // namespace gbl
