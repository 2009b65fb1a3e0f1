#include "renderer/truth/texture_levels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/picture/srgb.h"

namespace gbl {
namespace {

bool has_mipmaps(const Texture& t) { return t.sampler.min != Filter::nearest && t.sampler.min != Filter::linear; }

double decoded(double code) {
  static const std::array<double, 256> kBytes = [] {
    std::array<double, 256> t{};
    for (size_t i = 0; i < t.size(); ++i) t[i] = linear_from_srgb(double(i) / 255);
    return t;
  }();
  const double byte = code * 255;
  return byte == std::floor(byte) ? kBytes[static_cast<size_t>(byte)] : linear_from_srgb(code);
}

glm::dvec4 base_texel(const Texture& t, bool srgb, glm::ivec2 at) {
  glm::dvec4 out = t.texel(static_cast<size_t>(at.y) * static_cast<size_t>(t.size.x) + static_cast<size_t>(at.x));
  if (srgb)
    for (int k = 0; k < 3; ++k) out[k] = decoded(out[k]);
  return out;
}

}  // namespace

int wrapped_texel(int i, int size, Wrap wrap) {
  const auto modulo = [](int a, int n) { return ((a % n) + n) % n; };
  switch (wrap) {
    case Wrap::clamp: return std::clamp(i, 0, size - 1);
    case Wrap::mirror: {
      const int twice = modulo(i, 2 * size);
      return twice < size ? twice : 2 * size - 1 - twice;
    }
    case Wrap::repeat: break;
  }
  return modulo(i, size);
}

TextureLevels::TextureLevels(const Scene& scene, bool srgb)
    : scene_(scene), srgb_(scene.textures.size()), linear_(scene.textures.size()) {
  const auto add = [&](const TextureUse& use, bool decodes) {
    if (use.texture == kNoTexture) return;
    Pyramid& p = (decodes ? srgb_ : linear_)[static_cast<size_t>(use.texture)];
    if (p.levels.empty()) p = pyramid_of(scene.textures[static_cast<size_t>(use.texture)], decodes);
  };
  for (const Material& m : scene.materials) {
    for (const TextureUse* use : {&m.base_colour_texture, &m.emissive_texture, &m.specular_colour_texture})
      add(*use, srgb);
    for (const TextureUse* use : {&m.normal_texture, &m.roughness_texture, &m.occlusion_texture, &m.specular_texture})
      add(*use, false);
  }
}

TextureLevels::Pyramid TextureLevels::pyramid_of(const Texture& t, bool srgb) {
  Pyramid out;
  if (t.empty() || !has_mipmaps(t)) return out;
  const auto above = [&](glm::ivec2 at) {
    if (out.levels.empty()) return glm::vec4(base_texel(t, srgb, at));
    const Level& l = out.levels.back();
    return l.texels[static_cast<size_t>(at.y) * static_cast<size_t>(l.size.x) + static_cast<size_t>(at.x)];
  };
  glm::ivec2 size = t.size;
  while (size != glm::ivec2(1)) {
    Level next{glm::max(size / 2, 1), {}};
    for (int y = 0; y < next.size.y; ++y)
      for (int x = 0; x < next.size.x; ++x) {
        const glm::ivec2 low(2 * x, 2 * y), high = glm::min(low + 1, size - 1);
        next.texels.push_back(
            (above(glm::min(low, high)) + above({high.x, low.y}) + above({low.x, high.y}) + above(high)) / 4.0f);
      }
    size = next.size;
    out.levels.push_back(std::move(next));
  }
  return out;
}

glm::dvec4 TextureLevels::texel(const Texture& t, const Pyramid& p, bool srgb, int level, glm::ivec2 at) const {
  const glm::ivec2 size = level == 0 ? t.size : p.levels[static_cast<size_t>(level - 1)].size;
  at = {wrapped_texel(at.x, size.x, t.sampler.wrap_u), wrapped_texel(at.y, size.y, t.sampler.wrap_v)};
  if (level == 0) return base_texel(t, srgb, at);
  return p.levels[static_cast<size_t>(level - 1)]
      .texels[static_cast<size_t>(at.y) * static_cast<size_t>(size.x) + static_cast<size_t>(at.x)];
}

glm::dvec4 TextureLevels::level_at(const Texture& t, const Pyramid& p, bool srgb, int level,
                                   const glm::dvec2& uv) const {
  const glm::dvec2 size(level == 0 ? t.size : p.levels[static_cast<size_t>(level - 1)].size);
  const glm::dvec2 at = uv * size - 0.5, low = glm::floor(at), share = at - low;
  const auto one = [&](int dx, int dy) { return texel(t, p, srgb, level, glm::ivec2(low) + glm::ivec2(dx, dy)); };
  return glm::mix(glm::mix(one(0, 0), one(1, 0), share.x), glm::mix(one(0, 1), one(1, 1), share.x), share.y);
}

glm::dvec4 TextureLevels::at(int texture, bool srgb, const glm::dvec2& uv, const glm::dvec2& beside,
                             const glm::dvec2& below) const {
  if (texture == kNoTexture) return glm::dvec4(1);
  const auto index = static_cast<size_t>(texture);
  const Texture& t = scene_.textures[index];
  if (t.empty() || !(std::abs(uv.x) < 1e6 && std::abs(uv.y) < 1e6)) return glm::dvec4(1);
  const Pyramid& p = (srgb ? srgb_ : linear_)[index];
  const glm::dvec2 size(t.size);
  const double scale = std::max(glm::length(beside * size), glm::length(below * size));
  const double most = static_cast<double>(p.levels.size());
  const double level = std::isfinite(scale) ? std::clamp(std::log2(std::max(scale, 1.0)), 0.0, most) : most;
  const int low = static_cast<int>(level), high = std::min(low + 1, static_cast<int>(p.levels.size()));
  return glm::mix(level_at(t, p, srgb, low, uv), level_at(t, p, srgb, high, uv), level - low);
}

}  // namespace gbl
