#pragma once
// A frame seen from another place: what its G-buffer knows as points, its camera, its planes, and the picked light's mesh as
// the method draws it.
#include "renderer/inspect/views.h"
#include "renderer/passes/canvas.h"
#include "renderer/scene/camera.h"

namespace gbl {

struct OutsideView {
  Camera from;
  glm::ivec2 size{0};
  bool operator==(const OutsideView&) const = default;
};

// Colours by what a point, a line or a face is; display-coded.
inline constexpr glm::vec3 kFrustumColour{0.95f, 0.83f, 0.40f}, kNearPlaneColour{0.34f, 0.71f, 0.91f};

}  // namespace gbl
