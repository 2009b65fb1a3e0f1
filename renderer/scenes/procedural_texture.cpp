#include "renderer/scenes/procedural_texture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "renderer/base/random.h"
#include "renderer/scenes/texture_painting.h"

namespace gbl {
namespace {

// Gradient noise is 0 on its lattice. Octave i is shifted by i times this (in tiles), or all would be 0 together:
// a spike in ridged noise wherever the lattices meet.
constexpr glm::dvec2 kOctaveShift(0.1371, 0.2913);

constexpr glm::dvec3 kPaints[] = {{236, 232, 222}, {30, 27, 26}, {214, 152, 142}, {196, 182, 150},
                                  {62, 52, 44},    {58, 60, 64}, {246, 226, 170}, {150, 118, 62}};
constexpr int kPaintCount = 8;
constexpr double kSpotsHeight = 0.75;

double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

int wrapped(int cell, int cells) {
  if (cell >= 0 && cell < cells) return cell;  // nearly always: no division
  return ((cell % cells) + cells) % cells;
}

// Worn stones: at most one per lattice cell, at a random place and of a random size. 0..1.
ScalarMap make_pebbles(int size, int cells, uint64_t seed) {
  const TileNoise dents(seed);
  struct Pebble {
    glm::dvec2 place;
    double radius;
  };
  Pcg32 rng(seed);
  std::vector<Pebble> pebbles(static_cast<size_t>(cells) * cells);
  for (Pebble& p : pebbles) {
    p.place = {rng.in(0.2, 0.8), rng.in(0.2, 0.8)};
    p.radius = rng.unit() < 0.4 ? rng.in(0.15, 0.48) : 0.0;
  }
  return make_map(size, [&](double u, double v) {
    const glm::dvec2 dent(dents.at(u, v, 2 * cells), dents.at(v, u, 2 * cells));
    const glm::dvec2 p = glm::dvec2(u, v) * static_cast<double>(cells) + dent * 0.16;
    const glm::ivec2 cell(floor_of(p.x), floor_of(p.y));  // may lie one outside the tile
    double highest = 0;
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) {
        const int row = wrapped(cell.y + j, cells), column = wrapped(cell.x + i, cells);
        const Pebble& pebble = pebbles[row * cells + column];
        if (pebble.radius == 0) continue;
        const glm::dvec2 d = p - glm::dvec2(cell + glm::ivec2(i, j)) - pebble.place;
        const double t = 1 - glm::dot(d, d) / (pebble.radius * pebble.radius);
        if (t > 0) highest = std::max(highest, pebble.radius * 2 * std::sqrt(t));
      }
    return highest;
  });
}

}  // namespace

TileNoise::TileNoise(uint64_t seed) {
  Pcg32 rng(seed);
  for (uint32_t i = 0; i < 256; ++i) permutation_[i] = static_cast<uint8_t>(i);
  for (uint32_t i = 255; i > 0; --i) std::swap(permutation_[i], permutation_[rng.next() % (i + 1)]);
  std::copy_n(permutation_.begin(), 256, permutation_.begin() + 256);
}

double TileNoise::at(double u, double v, int cells) const {
  assert(cells >= 1 && cells <= 256);
  // Eight directions 45 degrees apart; lattice points must not all slope the same way along the axes.
  constexpr double kH = 0.70710678118654752;
  constexpr double kGradient[8][2] = {{1, 0}, {kH, kH}, {0, 1}, {-kH, kH}, {-1, 0}, {-kH, -kH}, {0, -1}, {kH, -kH}};
  const double x = u * cells, y = v * cells;
  const int cell_x = floor_of(x), cell_y = floor_of(y);
  const double fx = x - cell_x, fy = y - cell_y;
  const int x0 = wrapped(cell_x, cells), x1 = wrapped(cell_x + 1, cells);
  const int y0 = wrapped(cell_y, cells), y1 = wrapped(cell_y + 1, cells);
  const auto corner = [&](int cx, int cy, double dx, double dy) {
    const double* g = kGradient[permutation_[permutation_[static_cast<size_t>(cx)] + cy] & 7];
    return g[0] * dx + g[1] * dy;
  };
  const double sx = fade(fx), sy = fade(fy);
  const double top = corner(x0, y0, fx, fy) * (1 - sx) + corner(x1, y0, fx - 1, fy) * sx;
  const double bottom = corner(x0, y1, fx, fy - 1) * (1 - sx) + corner(x1, y1, fx - 1, fy - 1) * sx;
  return (top * (1 - sy) + bottom * sy) * 1.4;  // single octaves reach about 0.7
}

double TileNoise::fractal(double u, double v, int cells, int octaves, double gain) const {
  double sum = 0, height = 1, total = 0;
  for (int i = 0; i < octaves; ++i, height *= gain, cells *= 2) {
    sum += at(u + i * kOctaveShift.x, v + i * kOctaveShift.y, cells) * height;
    total += height;
  }
  return sum / total;
}

double TileNoise::ridged(double u, double v, int cells, int octaves) const {
  double sum = 0, height = 1, total = 0;
  for (int i = 0; i < octaves; ++i, height *= 0.5, cells *= 2) {
    const double crest = 1 - std::min(std::abs(at(u + i * kOctaveShift.x, v + i * kOctaveShift.y, cells)), 1.0);
    sum += crest * crest * height;
    total += height;
  }
  return sum / total;
}

// Change from texel to texel, {right, up}.
static glm::dvec2 gradient(const ScalarMap& height, int x, int y) {
  return glm::dvec2(height.at(x + 1, y) - height.at(x - 1, y), height.at(x, y - 1) - height.at(x, y + 1)) * 0.5;
}

// Times this, in texels, the map's root-mean-square slope is `slope`.
static double height_scale(const ScalarMap& height, double slope) {
  const int size = height.size;
  double square_sum = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) square_sum += glm::dot(gradient(height, x, y), gradient(height, x, y));
  return square_sum > 0 ? slope / std::sqrt(square_sum / (static_cast<double>(size) * size)) : 0;
}

Texture normal_map(std::string name, const ScalarMap& height, double slope) {
  assert((height.size & (height.size - 1)) == 0);
  const double scale = height_scale(height, slope);
  return make_texture(std::move(name), height.size, [&](int x, int y) {
    const glm::dvec3 n = glm::normalize(glm::dvec3(-gradient(height, x, y) * scale, 1));
    return (n * 0.5 + 0.5) * 255.0;
  });
}

Texture height_map(std::string name, const ScalarMap& height) {
  const auto [low, high] = std::minmax_element(height.texels.begin(), height.texels.end());
  Texture texture{std::move(name), glm::ivec2(height.size), {}, {}, {.min = Filter::linear}};
  const double range = std::max(*high - *low, 1e-9);
  for (const double h : height.texels) {
    const auto code = static_cast<uint16_t>(std::lround((h - *low) / range * 65535));
    texture.rgba16.insert(texture.rgba16.end(), {code, code, code, 65535});
  }
  return texture;
}

double height_depth(const ScalarMap& height, double slope) {
  const auto [low, high] = std::minmax_element(height.texels.begin(), height.texels.end());
  return (*high - *low) * height_scale(height, slope) / height.size;
}

GroundTextures make_ground_textures(int size, uint64_t seed) {
  const TileNoise noise(seed), wet_noise(seed + 1);
  const ScalarMap soil = make_map(size, [&](double u, double v) { return noise.fractal(u, v, 8, 5, 0.55); });
  const ScalarMap tone = make_map(size, [&](double u, double v) { return noise.fractal(v, u, 6, 4, 0.6); });
  const ScalarMap stones = make_pebbles(size, 24, seed + 2);
  const ScalarMap wet = make_map(size, [&](double u, double v) {
    const double level = wet_noise.fractal(u, v, 4, 3, 0.4);
    return smoothstep(0.12, 0.34, level - 0.15 * noise.at(u, v, 16));
  });
  ScalarMap height{size, std::vector<double>(soil.texels.size())};
  for (size_t i = 0; i < height.texels.size(); ++i)
    height.texels[i] = (soil.texels[i] + 0.35 * stones.texels[i]) * (1 - 0.55 * wet.texels[i]);  // puddles are smoother

  GroundTextures t;
  t.normal = normal_map("ground normal", height, 0.23);
  t.wetness = make_texture("ground wetness", size, [&](int x, int y) {
    const double dry = 0.8 + 0.12 * soil.at(x, y), w = wet.at(x, y);
    const double roughness = std::clamp(dry * (1 - w) + 0.34 * w, 0.3, 0.92);
    return glm::dvec3(255, 255 * roughness, 0);
  });
  t.albedo = make_texture("ground albedo", size, [&](int x, int y) {
    const glm::dvec3 dark(122, 80, 56), light(186, 144, 108), stone(176, 146, 120);
    const double hollow = soil.at(x, y);  // crests are dusty, hollows dark
    const double mix = std::clamp(0.52 + 0.55 * tone.at(x, y) + 0.5 * hollow, 0.0, 1.0);
    const glm::dvec3 earth = dark + (light - dark) * mix;
    const double on_stone = smoothstep(0.1, 0.5, stones.at(x, y)) * 0.5;
    return (earth + (stone - earth) * on_stone) * (1 - 0.14 * wet.at(x, y));
  });
  return t;
}

Texture make_stone_albedo(int size, uint64_t seed) {
  const TileNoise noise(seed);
  return make_texture("stone albedo", size, [&](int x, int y) {
    const double u = (x + 0.5) / size, v = (y + 0.5) / size;
    const double grain = noise.fractal(u, v, 4, 5, 0.6);
    const double crack = smoothstep(0.86, 0.98, noise.ridged(u, v, 4, 2));
    const glm::dvec3 pale(188, 178, 160), dark(132, 122, 108);
    return (dark + (pale - dark) * std::clamp(0.55 + 0.7 * grain, 0.0, 1.0)) * (1 - 0.2 * crack);
  });
}

Texture make_paint(int size, uint64_t seed) {
  const TileNoise noise(seed);
  return make_texture("paint", size, [&](int x, int y) {
    const double u = (x + 0.5) / size, v = (y + 0.5) / size;
    if (v >= kSpotsHeight) return kPaints[std::min(static_cast<int>(u * kPaintCount), kPaintCount - 1)];
    const double black = smoothstep(-0.02, 0.02, noise.fractal(u, v / kSpotsHeight, 4, 2, 0.3) - 0.1);
    return kPaints[0] + (kPaints[1] - kPaints[0]) * black;
  });
}

glm::dvec2 paint_uv(Paint paint) {
  return {(static_cast<int>(paint) + 0.5) / kPaintCount, kSpotsHeight + (1 - kSpotsHeight) / 2};
}

}  // namespace gbl
