#pragma once
// Textures made by code. All repeat without a seam, and all are the same to the bit on every machine: the lattice is
// integers from Pcg32, and only + - * / sqrt and floor follow (no libm function whose last bit differs).
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "renderer/scene/scene.h"

namespace gbl {

// Gradient noise (Perlin 2002, "Improving Noise") on a lattice that repeats after `cells` cells, at most 256.
class TileNoise {
 public:
  explicit TileNoise(uint64_t seed);
  double at(double u, double v, int cells) const;  // u, v: one tile is 0..1; about -1..1
  // Octaves of twice the cells and `gain` times the height each; about -1..1. cells * 2^(octaves-1) <= 256.
  double fractal(double u, double v, int cells, int octaves, double gain = 0.5) const;
  // Sharp crests where the noise changes sign; 0..1.
  double ridged(double u, double v, int cells, int octaves) const;

 private:
  std::array<uint8_t, 512> permutation_;
};

// A square of numbers that wraps at its edges.
struct ScalarMap {
  int size = 0;
  std::vector<double> texels;  // rows top to bottom
  double at(int x, int y) const { return texels[(y & (size - 1)) * size + (x & (size - 1))]; }
};

// Tangent-space normals, +Y up the picture, of a height map scaled so that its root-mean-square slope is `slope`
// (0.2: tilts of about 11 degrees). The map's size must be a power of two.
Texture normal_map(std::string name, const ScalarMap& height, double slope);

// The same height map as a texture, 0..1 in 16 bits, and how far its lowest place lies below its highest with these slopes, in
// widths of the tile.
Texture height_map(std::string name, const ScalarMap& height);
double height_depth(const ScalarMap& height, double slope);

struct GroundTextures {
  Texture albedo;  // reddish-brown earth, sRGB
  Texture normal;
  Texture wetness;  // green = roughness: 0.18 in puddles to 0.9 on dry ground; blue = metal: none
};
GroundTextures make_ground_textures(int size, uint64_t seed);

Texture make_stone_albedo(int size, uint64_t seed);

// One texture for all painted things: the upper 3/4 are a cow's spots, the lowest quarter eight plain swatches.
enum class Paint { white, black, pink, horn, hoof, iron, glass, brass };
Texture make_paint(int size, uint64_t seed);
glm::dvec2 paint_uv(Paint);  // centre of the swatch

}  // namespace gbl
