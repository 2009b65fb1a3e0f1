#pragma once
// More views of a scene than its own, the same ones every time: a study that is run from one place only says something
// about that place.
#include "renderer/scene/scene.h"

namespace gbl {

// k = 0: `own`. k > 0: the k-th camera about the point that `own` looks at, at the depth of the scene's centre: turned
// by up to 60 degrees sideways and 15 up or down, at 0.6 to 1.4 of the distance, without roll; inside the scene's
// bounds if `own` is. Field of view and planes are kept. Places inside or behind things are passed over: at least a
// third of a grid of rays meet a surface, and none from behind. If no place of 64 is good, it is `own`. Always finite.
Camera seeded_camera(const Scene&, const Camera& own, int k);

}  // namespace gbl
