// Fronts, streets and signs.
#include <cassert>

#include "renderer/scenes/surface_textures.h"
#include "renderer/scenes/texture_painting.h"

namespace gbl {
namespace {

// Rows from the top, 5 dots each, the leftmost in the highest bit.
struct Glyph {
  char letter;
  uint8_t rows[7];
};
constexpr int kGlyphWidth = 5, kGlyphHeight = 7;
constexpr Glyph kGlyphs[] = {
    {'D', {0b11110, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b11110}},
    {'E', {0b11111, 0b10000, 0b10000, 0b11110, 0b10000, 0b10000, 0b11111}},
    {'F', {0b11111, 0b10000, 0b10000, 0b11110, 0b10000, 0b10000, 0b10000}},
    {'R', {0b11110, 0b10001, 0b10001, 0b11110, 0b10100, 0b10010, 0b10001}},
};

// Is there a lamp in this column and row of dots? One empty dot lies around and between the letters.
bool lamp_at(std::string_view text, int column, int row) {
  const int place = (column - 1) / (kGlyphWidth + 1), x = (column - 1) % (kGlyphWidth + 1), y = row - 1;
  if (column < 1 || x >= kGlyphWidth || y < 0 || y >= kGlyphHeight) return false;
  if (place >= static_cast<int>(text.size())) return false;
  for (const Glyph& g : kGlyphs)
    if (g.letter == text[static_cast<size_t>(place)]) return (g.rows[y] >> (kGlyphWidth - 1 - x)) & 1;
  return false;
}

// Metres within a tile's own storey and window axis, from the lower left.
struct FacadePlace {
  double x, y;
  int column, storey;
};
FacadePlace facade_place(double u, double v) {
  return {4 * fraction(u * 4), 4 * (1 - fraction(v * 4)), floor_of(u * 4), floor_of(v * 4)};
}

// 1 in the middle of a window, 0 on the wall.
double glass(const FacadePlace& p) {
  const double across = std::min(p.x - kWindowLeft, kWindowRight - p.x);
  return smoothstep(0, 0.12, std::min(across, std::min(p.y - kWindowBottom, kWindowTop - p.y)));
}

// Metres from the nearest street's middle, along both axes of a block.
struct BlockPlace {
  double from_x, from_y;    // streets along v and along u
  double along_x, along_y;  // metres from the tile's corner
};
BlockPlace block_place(double u, double v) {
  return {40 * std::min(u, 1 - u), 40 * std::min(v, 1 - v), 40 * u, 40 * v};
}

constexpr double kHalfRoad = 5.5, kPavementEnd = 8;

double road_paint(const BlockPlace& p) {
  const auto line = [](double from, double other, double along) {  // dashes in the middle of the road
    if (other < kHalfRoad + 4) return 0.0;
    return from < 0.12 && fraction(along / 4) < 0.5 ? 1.0 : 0.0;
  };
  const auto zebra = [](double across, double along) {
    const bool here = across < kHalfRoad - 0.4 && along > kHalfRoad + 0.6 && along < kHalfRoad + 3.2;
    return here && fraction(across / 1.2) < 0.5 ? 1.0 : 0.0;
  };
  return std::max({line(p.from_x, p.from_y, p.along_y), line(p.from_y, p.from_x, p.along_x), zebra(p.from_x, p.from_y),
                   zebra(p.from_y, p.from_x)});
}

}  // namespace

SurfaceTextures make_facade(int size, uint64_t seed) {
  const TileNoise noise(seed);
  return painted(
      "facade", size, 0.18,
      [&](double u, double v) {
        const FacadePlace p = facade_place(u, v);
        const double band = smoothstep(0.1, 0.25, p.y) - smoothstep(3.75, 3.9, p.y);
        return 0.2 * band - glass(p) + 0.02 * noise.fractal(u, v, 32, 3);
      },
      [&](const Spot& s) {
        const FacadePlace p = facade_place(s.u, s.v);
        const glm::dvec3 wall = glm::dvec3(214, 208, 198) * (1 + 0.12 * noise.fractal(s.u, s.v, 8, 5, 0.6));
        const double pane = cell_random(p.column, p.storey, seed);
        return mixed(wall, mixed({34, 42, 52}, {66, 78, 90}, pane), glass(p));
      },
      [](const Spot& s) { return 0.85 - 0.65 * glass(facade_place(s.u, s.v)); });
}

SurfaceTextures make_city_ground(int size, uint64_t seed) {
  const TileNoise noise(seed);
  const auto road = [](const BlockPlace& p) { return std::min(p.from_x, p.from_y) < kHalfRoad; };
  const auto pavement = [](const BlockPlace& p) { return std::min(p.from_x, p.from_y) < kPavementEnd; };
  return painted(
      "city ground", size, 0.12,
      [&](double u, double v) {
        const BlockPlace p = block_place(u, v);
        const double slab = std::min({fraction(p.along_x), fraction(p.along_y), 0.08}) / 0.08;
        return (road(p) ? 0.0 : 0.6 + 0.1 * slab) + 0.25 * noise.fractal(u, v, 48, 3, 0.7);
      },
      [&](const Spot& s) {
        const BlockPlace p = block_place(s.u, s.v);
        const double worn = 1 + 0.16 * noise.fractal(s.u, s.v, 8, 5, 0.6);
        if (road(p)) return mixed(glm::dvec3(66, 67, 70) * worn, {206, 204, 194}, road_paint(p));
        return (pavement(p) ? glm::dvec3(150, 146, 140) : glm::dvec3(104, 106, 96)) * worn;
      },
      [&](const Spot& s) { return road(block_place(s.u, s.v)) ? 0.55 : 0.85; });
}

Texture make_sign(std::string_view text, glm::dvec3 colour) {
  constexpr int kDot = 12;  // texels
  const int columns = 1 + static_cast<int>(text.size()) * (kGlyphWidth + 1), rows = kGlyphHeight + 2;
  Texture sign = make_texture("sign", {columns * kDot, rows * kDot}, [&](int x, int y) {
    const int column = x / kDot, row = y / kDot;
    const glm::dvec2 off(x % kDot + 0.5 - kDot / 2.0, y % kDot + 0.5 - kDot / 2.0);
    const double lamp = 1 - smoothstep(3.5, 5.5, std::sqrt(glm::dot(off, off)));
    return colour * lamp * (lamp_at(text, column, row) ? 1.0 : 0.05);
  });
  sign.sampler.wrap_u = sign.sampler.wrap_v = Wrap::clamp;
  return sign;
}

}  // namespace gbl
