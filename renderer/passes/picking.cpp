// Which object is seen where: drawn on demand, so that no layout has to store ids, and read back without waiting.
#include "renderer/passes/objects.h"

namespace gbl {

void draw_ids(Frame& frame) {
  Canvases& canvases = frame.targets().canvases;
  if (canvases.ids_valid) return;
  const glm::ivec2 size = frame.settings.size;
  const gl::Framebuffer& into = canvases.ids(frame.targets().frame).framebuffer;
  begin_drawing(into, size, {});
  constexpr GLuint kNone[4] = {};
  glClearBufferuiv(GL_COLOR, 0, kNone);
  for (const bool transparent : {false, true}) {
    const std::vector<ObjectDraw> draws = prepare_objects(frame, transparent);
    begin_drawing(into, size, depth_tested(frame, gl::DepthTest::less_equal, {}));
    draw_objects(frame, draws, "ids.frag", frame.surface_defines());
  }
  canvases.ids_valid = true;
}

void draw_outline(Frame& frame, Canvas& into) {
  if (frame.view.object == 0) return;
  draw_ids(frame);
  begin_drawing(into.framebuffer, frame.settings.size, {});
  gl::bind_texture("ids", frame.targets().canvases.ids().texture);
  const gl::Program& program = frame.programs.get("fullscreen.vert", "outline.frag", {});
  glUseProgram(program.id());
  glUniform1i(program.uniform("picked"), frame.view.object);
  frame.shapes.draw_fullscreen();
}

}  // namespace gbl
