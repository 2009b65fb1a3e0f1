// Tiles of pixels, each with its own lights: a compute shader, where the driver has them.
#include <string>

#include "renderer/passes/lighting.h"

namespace gbl {
namespace {

std::vector<const gl::Texture*> images_of(const LightingPass& pass) {
  const FrameTextures& t = pass.frame.targets().frame;
  switch (pass.output) {
    case LightOutput::split: return {t.texture(Stores::diffuse_light), t.texture(Stores::specular_light)};
    case LightOutput::sum: return {t.texture(Stores::light)};
    case LightOutput::lit: break;  // it does not read pixels once: light_methods.inc
    case LightOutput::count: return {&pass.frame.targets().canvases.counts().texture};
  }
  return {};
}

const gl::Program& tile_program(const LightingPass& pass, Format format) {
  gl::Defines defines = pass.defines();
  defines.push_back({"TILE", kTile});
  defines.push_back({"IMAGE_FORMAT", static_cast<int>(format)});
  for (const Format f : {Format::rgba8, Format::r11g11b10f, Format::rgba16f})
    defines.push_back({std::string("FORMAT_") + row(f).label, static_cast<int>(f)});
  return pass.frame.programs.get_compute("light_tiled.comp", defines);
}

}  // namespace

int draw_tiled_lights(const LightingPass& pass) {
  const std::vector<const gl::Texture*> images = images_of(pass);
  glUseProgram(tile_program(pass, images[0]->format).id());
  for (GLuint i = 0; i < images.size(); ++i)
    glBindImageTexture(i, images[i]->id(), 0, GL_FALSE, 0, GL_READ_WRITE, gl::gl_format(images[i]->format).internal);
  const glm::ivec2 tiles = (pass.frame.settings.size + kTile - 1) / kTile;
  glDispatchCompute(static_cast<GLuint>(tiles.x), static_cast<GLuint>(tiles.y), 1);
  // What comes next samples the images, draws onto them or reads them back.
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                  GL_PIXEL_BUFFER_BARRIER_BIT);
  return 1;
}

}  // namespace gbl
