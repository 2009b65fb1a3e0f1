#pragma once
// Where a triangle is met, as its textures see it: on the CPU, the nearest texel.
#include "renderer/scene/scene.h"

namespace gbl {

struct TextureAt {
  glm::dvec2 uv[2] = {glm::dvec2(0), glm::dvec2(0)};  // of the two sets
  double alpha = 0;                                   // of the vertices' colours

  // corner: three of the mesh's indices.
  TextureAt(const Mesh&, const uint32_t* corner, const glm::dvec3& weights);

  // 0..1 as stored; white where there is no texture.
  glm::dvec4 nearest(const Scene&, const TextureUse&) const;
  // As the texture counts: of the set that is read, moved as the use says.
  glm::dvec2 uv_of(const TextureUse& use) const {
    return glm::dvec2(glm::dmat3(use.uv_transform) * glm::dvec3(uv[use.uv_set], 1));
  }
};

// Is a masked material's triangle cut out there?
bool in_hole(const Scene&, const Mesh&, const uint32_t* corner, const Material&, const glm::dvec3& weights);

}  // namespace gbl
