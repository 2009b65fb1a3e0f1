#pragma once
// What the panel of the outside camera asks of the app, and gets.
#include "renderer/inspect/views.h"
#include "renderer/scene/camera.h"

namespace gbl::ui {

struct OutsideRequest {
  Camera from;
  glm::ivec2 size{0};  // of its picture, in screen pixels
  View colours = View::final;
  bool operator==(const OutsideRequest&) const = default;
};

}  // namespace gbl::ui
