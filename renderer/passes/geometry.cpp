// Opaque and masked objects into the G-buffer, nearest first.
#include "renderer/passes/objects.h"

namespace gbl {
namespace {

void clear_gbuffer(const Targets& targets) {
  int buffer = 0;
  for (const Attachment& a : targets.attachments()) {
    if (a.written_by != Pass::geometry) continue;
    constexpr float kZero[4] = {}, kFarthest = 1;
    constexpr GLuint kZeroCodes[4] = {};
    constexpr GLint kUnmarked = 0;
    switch (row(a.format).numeric) {
      case Numeric::depth:
        glClearBufferfv(GL_DEPTH, 0, &kFarthest);
        if (row(a.format).stencil) glClearBufferiv(GL_STENCIL, 0, &kUnmarked);
        break;
      case Numeric::uint: glClearBufferuiv(GL_COLOR, buffer++, kZeroCodes); break;
      default: glClearBufferfv(GL_COLOR, buffer++, kZero); break;
    }
  }
}

}  // namespace

int draw_geometry(const Frame& frame) {
  const std::vector<ObjectDraw> draws = prepare_objects(frame, false);
  begin_drawing(frame.targets.framebuffer(Pass::geometry), frame.settings.size,
                {.depth = gl::DepthTest::less, .depth_write = true, .cull = gl::Cull::back});
  clear_gbuffer(frame.targets);
  gl::Defines defines = gbuffer_defines(frame.settings);
  defines.push_back({"FORWARD", 0});
  return draw_objects(frame, draws, "geometry.frag", defines);
}

}  // namespace gbl
