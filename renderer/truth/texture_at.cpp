#include "renderer/truth/texture_at.h"

#include <algorithm>
#include <cmath>

namespace gbl {
namespace {

int wrapped(double at, int size, Wrap wrap) {
  const double whole = std::floor(at);
  double within = at - whole;
  if (wrap == Wrap::clamp) within = std::clamp(at, 0.0, 1.0);
  if (wrap == Wrap::mirror && std::fmod(std::abs(whole), 2) == 1) within = 1 - within;
  return std::clamp(static_cast<int>(within * size), 0, size - 1);
}

}  // namespace

TextureAt::TextureAt(const Mesh& mesh, const uint32_t* corner, const glm::dvec3& weights) {
  for (int k = 0; k < 3; ++k) {
    const Vertex& v = mesh.vertices[corner[k]];
    uv[0] += weights[k] * glm::dvec2(v.uv), uv[1] += weights[k] * glm::dvec2(v.uv1);
    alpha += weights[k] * double(v.colour.a);
  }
}

glm::dvec4 TextureAt::nearest(const Scene& scene, const TextureUse& use) const {
  if (use.texture == kNoTexture) return glm::dvec4(1);
  const Texture& t = scene.textures[static_cast<size_t>(use.texture)];
  const glm::dvec3 at = glm::dmat3(use.uv_transform) * glm::dvec3(uv[use.uv_set], 1);
  if (t.empty() || !std::isfinite(at.x + at.y)) return glm::dvec4(1);
  const auto x = static_cast<size_t>(wrapped(at.x, t.size.x, t.sampler.wrap_u));
  const auto y = static_cast<size_t>(wrapped(at.y, t.size.y, t.sampler.wrap_v));
  return t.texel(y * static_cast<size_t>(t.size.x) + x);
}

bool in_hole(const Scene& scene, const Mesh& mesh, const uint32_t* corner, const Material& m,
             const glm::dvec3& weights) {
  if (m.alpha_mode != AlphaMode::mask) return false;
  const TextureAt at(mesh, corner, weights);
  return at.nearest(scene, m.base_colour_texture).a * at.alpha * double(m.base_colour.a) < double(m.alpha_cutoff);
}

}  // namespace gbl
