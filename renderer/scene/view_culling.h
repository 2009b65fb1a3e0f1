#pragma once
// What a box alone tells of whether anything in it can be in the picture.
#include "renderer/scene/camera.h"
#include "renderer/scene/scene.h"

namespace gbl {

// False only if all of the box lies beyond one side of the view, by more than float's rounding on the GPU.
bool may_be_seen(const Bounds&, const glm::dmat4& clip_from_box, DepthRuns);

}  // namespace gbl
