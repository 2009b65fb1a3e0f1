#pragma once
// How procedural textures are painted: a function at every texel. Only + - * / sqrt and floor, so that the texels are
// the same to the bit on every machine.
#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "renderer/base/random.h"
#include "renderer/scenes/surface_textures.h"

namespace gbl {

inline double smoothstep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

inline glm::dvec3 mixed(glm::dvec3 a, glm::dvec3 b, double t) { return a + (b - a) * t; }

inline int floor_of(double x) {  // several times as fast as std::floor where that is a library call
  const int whole = static_cast<int>(x);
  return whole - (x < whole ? 1 : 0);
}

inline double fraction(double x) { return x - floor_of(x); }

inline uint8_t to_byte(double value) { return static_cast<uint8_t>(std::clamp(value + 0.5, 0.0, 255.0)); }

// f(u, v) at the centres of the texels.
template <class F>
ScalarMap make_map(int size, F f) {
  ScalarMap map{size, {}};
  map.texels.reserve(static_cast<size_t>(size) * size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) map.texels.push_back(f((x + 0.5) / size, (y + 0.5) / size));
  return map;
}

// f(x, y) gives 0..255 per channel.
template <class F>
Texture make_texture(std::string name, glm::ivec2 size, F f) {
  Texture texture{std::move(name), size, {}, {}};
  texture.rgba.reserve(static_cast<size_t>(size.x) * size.y * 4);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glm::dvec3 c = f(x, y);
      texture.rgba.insert(texture.rgba.end(), {to_byte(c.x), to_byte(c.y), to_byte(c.z), 255});
    }
  return texture;
}

template <class F>
Texture make_texture(std::string name, int size, F f) {
  return make_texture(std::move(name), glm::ivec2(size), std::move(f));
}

// What a painter knows of one texel.
struct Spot {
  double u, v;
  double height;  // what the normal map is made of, 0..1 or so
};

// slope: root mean square of the normal map's (see normal_map). height(u, v), colour(Spot) 0..255, roughness(Spot).
template <class Height, class Colour, class Roughness>
SurfaceTextures painted(const std::string& name, int size, double slope, Height height, Colour colour,
                        Roughness roughness) {
  const ScalarMap heights = make_map(size, height);
  const auto spot = [&](int x, int y) { return Spot{(x + 0.5) / size, (y + 0.5) / size, heights.at(x, y)}; };
  SurfaceTextures t;
  t.normal = normal_map(name + " normal", heights, slope);
  t.height = height_map(name + " height", heights);
  t.depth = height_depth(heights, slope);
  t.albedo = make_texture(name + " albedo", size, [&](int x, int y) { return colour(spot(x, y)); });
  t.roughness = make_texture(name + " roughness", size, [&](int x, int y) {
    return glm::dvec3(255, 255 * std::clamp(roughness(spot(x, y)), 0.0, 1.0), 255);
  });
  return t;
}

// A number of its own for every cell of a lattice, 0..1.
inline double cell_random(int column, int row, uint64_t seed) {
  return Pcg32(seed * 7919 + static_cast<uint64_t>(column) * 131 + static_cast<uint64_t>(row)).unit();
}

// A lattice of columns x rows, odd rows shifted by half a cell.
struct Cell {
  int column, row;
  double x, y;  // 0..1 within the cell
};
inline Cell cell_of(double u, double v, int columns, int rows, double shift = 0.5) {
  const int row = floor_of(v * rows);
  const double x = u * columns + (row % 2) * shift;
  return {floor_of(x) % columns, row, fraction(x), fraction(v * rows)};
}

// Distance to the nearest edge of the cell, in widths of the tile.
inline double edge_distance(const Cell& c, int columns, int rows) {
  return std::min(std::min(c.x, 1 - c.x) / columns, std::min(c.y, 1 - c.y) / rows);
}

}  // namespace gbl
