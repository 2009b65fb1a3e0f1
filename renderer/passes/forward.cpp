// Forward shading of opaque surfaces, the other side of every tutorial's first claim: the light loop runs while the
// geometry is drawn. In one pass (hidden fragments pay, too), after a depth pass, or one pass per light.
#include "renderer/passes/forward.h"

#include "renderer/passes/lighting.h"

namespace gbl {
namespace {

using gl::DepthTest;

int draw_depth(const Frame& frame, const std::vector<ObjectDraw>& draws, const gl::Framebuffer& into) {
  begin_drawing(into, frame.settings.size,
                depth_tested(frame, DepthTest::less, {.depth_write = true, .colour_write = false}));
  return draw_objects(frame, draws, "depth_only.frag", frame.surface_defines());
}

int draw_visible(const Frame& frame, const std::vector<ObjectDraw>& draws, const gl::Framebuffer& into,
                 const ShadedDraw& draw, gl::Blend blend) {
  begin_drawing(into, frame.settings.size, depth_tested(frame, DepthTest::equal, {.blend = blend}));
  return draw_shaded_objects(frame, draws, draw);
}

int draw_light_by_light(const Frame& frame, const std::vector<ObjectDraw>& draws, const gl::Framebuffer& into,
                        LightOutput output) {
  int calls = 0;
  if (output == LightOutput::sum) calls += draw_visible(frame, draws, into, {output, {0, 0}, true}, gl::Blend::off);
  for (int i = 0; i < frame.light_count(); ++i)
    calls += draw_visible(frame, draws, into, {output, {i, i + 1}, false}, gl::Blend::add_colour);
  return calls;
}

}  // namespace

int draw_shaded_objects(const Frame& frame, const std::vector<ObjectDraw>& draws, const ShadedDraw& draw) {
  bind_lights(frame);
  gl::Defines defines = frame.shaded_defines();
  defines.push_back({"OUTPUT", static_cast<int>(draw.output)});
  defines.push_back({"ONE_LIGHT", draw.lights.y - draw.lights.x == 1});
  const glm::ivec2 span = glm::min(draw.lights, glm::ivec2(frame.light_count()));
  return draw_objects(frame, draws, "forward.frag", defines, [&](const gl::Program& program) {
    // An unlit surface reads neither.
    glUniform2i(program.find_uniform("light_span"), span.x, span.y);
    glUniform1f(program.find_uniform("ambient_share"), draw.ambient ? 1 : 0);
  });
}

int draw_forward(Frame& frame, LightOutput output, const gl::Framebuffer& into) {
  const std::vector<ObjectDraw> draws = prepare_objects(frame, false);
  const LightMethod method = frame.settings.lights.method;
  if (method == LightMethod::forward) {
    const gl::Blend blend = output == LightOutput::count ? gl::Blend::add : gl::Blend::off;
    begin_drawing(into, frame.settings.size,
                  depth_tested(frame, DepthTest::less, {.depth_write = true, .blend = blend}));
    clear_depth(frame);
    return draw_shaded_objects(frame, draws, {.output = output});
  }
  begin_drawing(into, frame.settings.size, depth_tested(frame, DepthTest::less, {.depth_write = true}));
  clear_depth(frame);
  const int calls = draw_depth(frame, draws, into);
  if (method == LightMethod::forward_multipass) return calls + draw_light_by_light(frame, draws, into, output);
  return calls + draw_visible(frame, draws, into, {.output = output},
                              output == LightOutput::count ? gl::Blend::add : gl::Blend::off);
}

int draw_forward_frame(Frame& frame) {
  const gl::Framebuffer& lit = frame.framebuffer(Pass::combine);
  return draw_background(frame, lit) + draw_forward(frame, LightOutput::sum, lit);
}

}  // namespace gbl
