// What a backpack is made of, four materials in one texture, so that a whole backpack is one mesh.
#include "renderer/scenes/surface_textures.h"
#include "renderer/scenes/texture_painting.h"

namespace gbl {
namespace {

Cloth cloth_at(double u, double v) { return static_cast<Cloth>((u < 0.5 ? 0 : 1) + (v < 0.5 ? 0 : 2)); }

// Threads over and under each other, 0..1.
double weave(double u, double v, int threads) {
  const double x = u * threads, y = v * threads;
  const bool over = (floor_of(x) + floor_of(y)) % 2;
  const double across = 2 * fraction(over ? x : y) - 1, along = 2 * fraction(over ? y : x) - 1;
  return (1 - across * across) * (1 - 0.4 * along * along);
}

glm::dvec3 stripes(double v) {  // of the wool
  const double x = fraction(v * 8);
  if (x < 0.16 || x > 0.84) return {226, 214, 188};
  if (x > 0.42 && x < 0.58) return {44, 62, 96};
  return {168, 48, 40};
}

}  // namespace

SurfaceTextures make_cloth(int size, uint64_t seed) {
  const TileNoise noise(seed);
  const auto height = [&](double u, double v) {
    switch (cloth_at(u, v)) {
      case Cloth::canvas: return 0.3 * weave(u, v, 128);
      case Cloth::leather: return 0.5 * (1 - noise.ridged(u, v, 40, 2));
      case Cloth::wool: return 0.35 * weave(u, v, 64) + 0.1 * noise.fractal(u, v, 48, 2);
      case Cloth::brass: return 0.02 * noise.at(u, 4 * v, 60);
    }
    return 0.0;
  };
  const auto colour = [&](const Spot& s) {
    const double worn = noise.fractal(s.u, s.v, 12, 4, 0.6);
    switch (cloth_at(s.u, s.v)) {
      case Cloth::canvas: return glm::dvec3(116, 122, 82) * (0.9 + 0.5 * s.height + 0.3 * worn);
      case Cloth::leather: return glm::dvec3(124, 72, 40) * (1.05 - 0.4 * s.height + 0.4 * worn);
      case Cloth::wool: return stripes(s.v) * (0.8 + 0.6 * s.height + 0.1 * worn);
      case Cloth::brass: return glm::dvec3(212, 172, 96) * (1 + 0.2 * worn);
    }
    return glm::dvec3(0);
  };
  const auto roughness = [&](const Spot& s) {
    constexpr double kRough[] = {0.9, 0.5, 0.95, 0.28};
    return kRough[static_cast<int>(cloth_at(s.u, s.v))] + 0.08 * noise.at(s.u, s.v, 20);
  };
  return painted("cloth", size, 0.28, height, colour, roughness);
}

glm::dvec2 cloth_uv(Cloth cloth) {
  constexpr double kMargin = (0.5 - kClothUv) / 2;
  const int i = static_cast<int>(cloth);
  return {(i % 2) * 0.5 + kMargin, (i / 2) * 0.5 + kMargin};
}

}  // namespace gbl
