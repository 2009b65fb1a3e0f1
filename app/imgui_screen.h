#pragma once
// Dear ImGui drawn through OpenGL, on a window or off screen: one UI for both.
#include <functional>
#include <glm/glm.hpp>

#include "renderer/gl/device.h"
#include "renderer/picture/image.h"
#include "ui/ui.h"

namespace gbl {

// The ImGui context and its GL back-end. Needs a current GL context; one at a time.
class ImguiScreen {
 public:
  explicit ImguiScreen(gl::Api = gl::device().api);
  ~ImguiScreen();
  ImguiScreen(const ImguiScreen&) = delete;

  // One frame into the bound framebuffer of this size: the caller has fed the inputs (or there are none).
  void draw(glm::ivec2 size, const std::function<void()>& panels);
  // The same off screen, as a picture.
  Image picture(glm::ivec2 size, const std::function<void()>& panels);

 private:
  gl::Api api_;
};

}  // namespace gbl
