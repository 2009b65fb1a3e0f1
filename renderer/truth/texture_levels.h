#pragma once
// The textures of a scene as a trilinear sampler reads them, in double: mipmaps, and four texels of two levels by the footprint
// that is asked for (OpenGL 4.6, section 8.14, with the exact square root for the scale factor). Filters that take the nearest
// texel or level are not told apart; a texture without mipmaps is read at its largest level.
#include <glm/glm.hpp>
#include <vector>

#include "renderer/scene/scene.h"

namespace gbl {

// The texel of a row that a place beside it stands for.
int wrapped_texel(int i, int size, Wrap);

class TextureLevels {
 public:
  // The scene must outlive it. srgb: are colours decoded when they are read?
  TextureLevels(const Scene&, bool srgb);

  // uv of the texel's place, and how it changes to the next pixel right and below. 0..1, linear: what is coded in sRGB is
  // decoded first, where `srgb` says so. White without a texture.
  glm::dvec4 at(int texture, bool srgb, const glm::dvec2& uv, const glm::dvec2& beside, const glm::dvec2& below) const;

 private:
  struct Level {
    glm::ivec2 size{0};
    std::vector<glm::vec4> texels;
  };
  struct Pyramid {
    std::vector<Level> levels;  // from half the size on
  };
  static Pyramid pyramid_of(const Texture&, bool srgb);
  glm::dvec4 texel(const Texture&, const Pyramid&, bool srgb, int level, glm::ivec2 at) const;
  glm::dvec4 level_at(const Texture&, const Pyramid&, bool srgb, int level, const glm::dvec2& uv) const;

  const Scene& scene_;
  std::vector<Pyramid> srgb_, linear_;  // of each texture; those that no material reads so are empty
};

}  // namespace gbl
