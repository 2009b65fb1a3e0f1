#pragma once
// Albedo, normal map and roughness of the things that built-in scenes are made of. All repeat without a seam and are
// the same to the bit on every machine (see procedural_texture.h). `size` is a power of two.
#include <cstdint>
#include <string_view>

#include "renderer/scenes/procedural_texture.h"

namespace gbl {

struct SurfaceTextures {
  Texture albedo;     // sRGB
  Texture normal;     // tangent space, +Y up the picture
  Texture roughness;  // green: roughness; blue: metal, 255 (the material's factor decides)
  Texture height;     // what the normal map is made of: 1 the highest place, 0 the lowest; 16 bits
  double depth = 0;   // between them, in widths of the tile, as the normal map's slopes ask
};

SurfaceTextures make_bricks(int size, uint64_t seed);      // 4 x 8 bricks a tile
SurfaceTextures make_bark(int size, uint64_t seed);        // ridges along v
SurfaceTextures make_planks(int size, uint64_t seed);      // 6 boards along u
SurfaceTextures make_tiles(int size, uint64_t seed);       // 4 x 4 polished stone tiles, a chequerboard
SurfaceTextures make_plaster(int size, uint64_t seed);     // nearly white: the material's colour tints it
SurfaceTextures make_panels(int size, uint64_t seed);      // 2 x 2 raised fields, nearly white
SurfaceTextures make_flutes(int size, uint64_t seed);      // 12 grooves along v, nearly white
SurfaceTextures make_roof_tiles(int size, uint64_t seed);  // 6 x 8 overlapping clay tiles
SurfaceTextures make_foliage(int size, uint64_t seed);
SurfaceTextures make_grass(int size, uint64_t seed);

// One tile is 16 m of a house front: 4 x 4 windows of dark glass. Where a window lies in its 4 m x 4 m:
inline constexpr double kWindowLeft = 1, kWindowRight = 3, kWindowBottom = 0.9, kWindowTop = 3.1;
SurfaceTextures make_facade(int size, uint64_t seed);
// One tile is one block of the city, 40 m: half a street along each side, pavements, a yard in the middle.
SurfaceTextures make_city_ground(int size, uint64_t seed);

// A quarter each for canvas, leather, striped wool and brass.
enum class Cloth { canvas, leather, wool, brass };
SurfaceTextures make_cloth(int size, uint64_t seed);
glm::dvec2 cloth_uv(Cloth);               // upper left corner of the part of one cloth that is safe to show,
inline constexpr double kClothUv = 0.44;  // and its side

// Letters of lamps on black; only those of "DEFERRED" are known. Not to be repeated.
Texture make_sign(std::string_view text, glm::dvec3 colour);

}  // namespace gbl
