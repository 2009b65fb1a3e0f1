#include "renderer/passes/normal_texels.h"

#include <cassert>

#include "renderer/frame/resolved_frame.h"
#include "renderer/gl/readback.h"
#include "renderer/gl/texture_units.h"
#include "renderer/passes/canvas.h"
#include "renderer/passes/passes.h"
#include "renderer/passes/programs.h"
#include "renderer/passes/shapes.h"
#include "renderer/scene/scene.h"

namespace gbl {
namespace {

// A fragment shader of this main() over all texels of `to`; it may call what normal_texel.glsl holds.
void draw(const gl::Defines& defines, const char* declares, const char* result, const gl::Texture& from,
          const Canvas& to) {
  gl::ShaderText fragment = gl::load_shader("normal_texel.glsl", defines);
  fragment.body +=
      std::string(declares) + "void main() {\n  ivec2 texel = ivec2(gl_FragCoord.xy);\n  result = " + result + ";\n}\n";
  const gl::Program program = gl::compile_program(gl::load_shader("fullscreen.vert", defines), fragment);
  begin_drawing(to.framebuffer, to.texture.size, {});
  gl::bind_texture("source", from);
  glUseProgram(program.id());
  Shapes().draw_fullscreen();
}

std::vector<glm::vec4> texels_of(const Canvas& c) {
  const std::vector<float> floats = gl::read_rgba32f(c.texture);  // in the order in which they were written
  std::vector<glm::vec4> out(floats.size() / 4);
  for (size_t i = 0; i < out.size(); ++i)
    out[i] = {floats[4 * i], floats[4 * i + 1], floats[4 * i + 2], floats[4 * i + 3]};
  return out;
}

}  // namespace

NormalTexels normals_through_gpu(const Settings& s, std::span<const glm::vec4> directions, glm::ivec2 size) {
  assert(directions.size() == static_cast<size_t>(size.x) * static_cast<size_t>(size.y));
  const gl::Defines defines = gbuffer_defines(resolve_frame(s, Scene{}, {}));
  const gl::Texture source = gl::make_texture({.size = size, .format = Format::rgba32f, .label = "directions"});
  gl::write_texels(source, directions.data());
  const Canvas stored = make_canvas({.size = size, .format = row_of(s.normal.encoding).format, .label = "normals"});
  const Canvas read = make_canvas({.size = size, .format = Format::rgba32f, .label = "normals.read"});
  draw(defines, "uniform sampler2D source;\nlayout(location = 0) out NORMAL_OUTPUT result;\n",
       "pack_normal(texelFetch(source, texel, 0).xyz)", source, stored);
  const char* reads = "uniform NORMAL_SAMPLER source;\nlayout(location = 0) out vec4 result;\n";
  NormalTexels out;
  draw(defines, reads, "vec4(code_from_texel(texelFetch(source, texel, 0)), 0.0)", stored.texture, read);
  out.codes = texels_of(read);
  draw(defines, reads, "vec4(unpack_normal(texelFetch(source, texel, 0)), 0.0)", stored.texture, read);
  out.decoded = texels_of(read);
  return out;
}

}  // namespace gbl
