#include "renderer/passes/function_runner.h"

#include <cassert>

#include "renderer/base/resources.h"
#include "renderer/base/sha256.h"
#include "renderer/gl/readback.h"
#include "renderer/gl/texture_units.h"
#include "renderer/passes/canvas.h"
#include "renderer/passes/passes.h"
#include "renderer/passes/shapes.h"

namespace gbl {
namespace {

gl::Texture texture_of(std::span<const glm::vec4> texels, glm::ivec2 size, std::string_view label) {
  std::vector<glm::vec4> padded(texels.begin(), texels.end());
  padded.resize(static_cast<size_t>(size.x) * static_cast<size_t>(size.y));
  gl::Texture t = gl::make_texture({.size = size, .format = Format::rgba32f, .label = label});
  gl::write_texels(t, padded.data());
  return t;
}

}  // namespace

std::vector<glm::vec4> call_glsl(const std::string& text, const std::string& shown, const std::string& call,
                                 std::span<const glm::vec4> a, std::span<const glm::vec4> b) {
  assert(a.size() == b.size() && !a.empty());
  const std::string file = "function-file/" + sha256(text).substr(0, 16);
  lend_resource("shaders/" + file, text, shown);
  constexpr int kWidth = 64;
  const glm::ivec2 size(kWidth, (static_cast<int>(a.size()) + kWidth - 1) / kWidth);
  const gl::Program program =
      gl::compile_program(gl::load_shader("fullscreen.vert", {}),
                          gl::load_shader("function.frag", {{"FUNCTION_FILE", file}, {"FUNCTION_CALL", call}}));
  const gl::Texture of_a = texture_of(a, size, "function.a"), of_b = texture_of(b, size, "function.b");
  const Canvas results = make_canvas({.size = size, .format = Format::rgba32f, .label = "function.results"});
  Shapes shapes;
  begin_drawing(results.framebuffer, size, {});
  gl::bind_texture("function_a", of_a);
  gl::bind_texture("function_b", of_b);
  glUseProgram(program.id());
  shapes.draw_fullscreen();
  const std::vector<float> floats = gl::read_rgba32f(results.texture);
  std::vector<glm::vec4> out(a.size());
  for (size_t i = 0; i < out.size(); ++i)
    out[i] = {floats[4 * i], floats[4 * i + 1], floats[4 * i + 2], floats[4 * i + 3]};
  return out;
}

}  // namespace gbl
