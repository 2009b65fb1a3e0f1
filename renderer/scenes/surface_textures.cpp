#include "renderer/scenes/surface_textures.h"

#include "renderer/scenes/texture_painting.h"

namespace gbl {
SurfaceTextures make_bricks(int size, uint64_t seed) {
  const TileNoise noise(seed);
  const auto brick = [&](double u, double v) {
    const Cell c = cell_of(u, v, 4, 8);
    const double worn = edge_distance(c, 4, 8) + 0.004 * noise.at(u, v, 24);
    return smoothstep(0.005, 0.014, worn);
  };
  return painted(
      "bricks", size, 0.34,
      [&](double u, double v) {
        const Cell c = cell_of(u, v, 4, 8);
        return brick(u, v) * (0.8 + 0.35 * cell_random(c.column, c.row, seed)) + 0.12 * noise.fractal(u, v, 16, 4, 0.6);
      },
      [&](const Spot& s) {
        const Cell c = cell_of(s.u, s.v, 4, 8);
        const double kind = cell_random(c.column, c.row, seed + 1);
        const glm::dvec3 clay = mixed({122, 58, 44}, {186, 98, 66}, kind), mortar(176, 168, 154);
        const double grain = 1 + 0.22 * noise.fractal(s.u, s.v, 16, 4, 0.6);
        return mixed(mortar, clay, brick(s.u, s.v)) * grain;
      },
      [&](const Spot& s) { return 0.92 - 0.14 * brick(s.u, s.v); });
}

SurfaceTextures make_bark(int size, uint64_t seed) {
  const TileNoise noise(seed);
  const auto ridge = [&](double u, double v) {  // four times as long as wide, bent a little
    const double bend = 0.03 * noise.at(u, v, 5);
    return 1 - noise.ridged(4 * (u + bend), v, 3, 3);
  };
  return painted(
      "bark", size, 0.5, [&](double u, double v) { return ridge(u, v) + 0.1 * noise.fractal(u, v, 24, 3, 0.6); },
      [&](const Spot& s) {
        const double moss = smoothstep(0.1, 0.5, noise.fractal(s.v, s.u, 3, 3, 0.5));
        const glm::dvec3 bark = mixed({58, 42, 32}, {150, 124, 98}, std::clamp(1.5 * s.height - 0.05, 0.0, 1.0));
        return mixed(bark, {104, 108, 62}, 0.45 * moss);
      },
      [](const Spot& s) { return 0.95 - 0.12 * s.height; });
}

SurfaceTextures make_planks(int size, uint64_t seed) {
  const TileNoise noise(seed);
  constexpr int kBoards = 6;
  const auto board = [](double u, double v) { return cell_of(u, v, 2, kBoards, 0.7); };
  const auto grain = [&](double u, double v) {  // drawn out along u; every board shows another part
    const double shift = 0.37 * floor_of(v * kBoards);
    return noise.fractal(u + shift, 6 * v, 5, 4, 0.6);
  };
  return painted(
      "planks", size, 0.16,
      [&](double u, double v) {
        return smoothstep(0.001, 0.006, edge_distance(board(u, v), 2, kBoards)) + 0.14 * grain(u, v);
      },
      [&](const Spot& s) {
        const Cell c = board(s.u, s.v);
        const double tone = 0.5 * cell_random(c.column, c.row, seed + 2) + 0.25 + 0.5 * grain(s.u, s.v);
        const double gap = smoothstep(0.0005, 0.004, edge_distance(c, 2, kBoards));
        return mixed({108, 68, 40}, {184, 132, 86}, std::clamp(tone, 0.0, 1.0)) * (0.35 + 0.65 * gap);
      },
      [&](const Spot& s) { return 0.42 + 0.2 * grain(s.u, s.v); });
}

SurfaceTextures make_tiles(int size, uint64_t seed) {
  const TileNoise noise(seed);
  const auto vein = [&](double u, double v, const Cell& c) {  // each tile is cut from another place
    const double cut = cell_random(c.column, c.row, seed) * 5;
    return smoothstep(0.84, 0.98, noise.ridged(u + cut, v - cut, 5, 3));
  };
  const auto joint = [](const Cell& c) { return smoothstep(0.0015, 0.006, edge_distance(c, 4, 4)); };
  return painted(
      "tiles", size, 0.12,
      [&](double u, double v) {
        const Cell c = cell_of(u, v, 4, 4, 0);
        return joint(c) + 0.02 * noise.at(u, v, 8);
      },
      [&](const Spot& s) {
        const Cell c = cell_of(s.u, s.v, 4, 4, 0);
        const bool dark = (c.column + c.row) % 2;
        const glm::dvec3 stone = dark ? glm::dvec3(74, 86, 92) : glm::dvec3(214, 206, 192);
        const glm::dvec3 veined =
            mixed(stone, dark ? glm::dvec3(150, 156, 156) : glm::dvec3(150, 140, 128), vein(s.u, s.v, c));
        return mixed({92, 88, 82}, veined, joint(c)) * (1 + 0.1 * noise.fractal(s.u, s.v, 8, 3));
      },
      [&](const Spot& s) {
        const Cell c = cell_of(s.u, s.v, 4, 4, 0);
        return 0.8 - 0.5 * joint(c) + 0.1 * vein(s.u, s.v, c);
      });
}

SurfaceTextures make_plaster(int size, uint64_t seed) {
  const TileNoise noise(seed);
  return painted(
      "plaster", size, 0.1, [&](double u, double v) { return noise.fractal(u, v, 8, 5, 0.6); },
      [&](const Spot& s) { return glm::dvec3(232, 229, 222) * (1 + 0.05 * s.height); },
      [](const Spot& s) { return 0.82 + 0.1 * s.height; });
}

SurfaceTextures make_panels(int size, uint64_t seed) {
  const TileNoise noise(seed);
  const auto field = [](double u, double v) {  // a bevel outside, a flat rim, a bevel inside
    const double d = edge_distance(cell_of(u, v, 2, 2, 0), 2, 2);
    return smoothstep(0.008, 0.026, d) - 0.6 * smoothstep(0.06, 0.075, d) + 0.6 * smoothstep(0.09, 0.125, d);
  };
  return painted(
      "panels", size, 0.3, [&](double u, double v) { return field(u, v) + 0.02 * noise.fractal(u, v, 8, 4); },
      [&](const Spot& s) { return glm::dvec3(226, 222, 214) * (0.82 + 0.18 * field(s.u, s.v)); },
      [&](const Spot& s) { return 0.5 + 0.12 * noise.fractal(s.u, s.v, 6, 3); });
}

SurfaceTextures make_flutes(int size, uint64_t seed) {
  const TileNoise noise(seed);
  return painted(
      "flutes", size, 0.45,
      [&](double u, double v) {
        const double x = 2 * fraction(u * 12) - 1;  // round grooves between sharp ridges
        return x * x * 0.5 + 0.01 * noise.fractal(u, v, 8, 4);
      },
      [&](const Spot& s) {
        const glm::dvec3 stone(228, 220, 204);
        return stone * (0.86 + 0.24 * s.height + 0.08 * noise.fractal(s.u, s.v, 4, 4, 0.6));
      },
      [&](const Spot& s) { return 0.6 + 0.1 * noise.fractal(s.u, s.v, 8, 3); });
}

SurfaceTextures make_roof_tiles(int size, uint64_t seed) {
  const TileNoise noise(seed);
  return painted(
      "roof tiles", size, 0.42,
      [&](double u, double v) {
        const Cell c = cell_of(u, v, 6, 8);
        const double x = 2 * c.x - 1;
        const double round = 0.35 * (1 - x * x * x * x);
        return round + 0.55 * c.y + 0.06 * noise.fractal(u, v, 16, 3);  // the lower edge lies on the next row
      },
      [&](const Spot& s) {
        const Cell c = cell_of(s.u, s.v, 6, 8);
        const glm::dvec3 clay = mixed({138, 62, 44}, {192, 98, 66}, cell_random(c.column, c.row, seed));
        return clay * (0.62 + 0.42 * s.height) * (1 + 0.2 * noise.fractal(s.u, s.v, 8, 4, 0.6));
      },
      [](const Spot&) { return 0.78; });
}

SurfaceTextures make_foliage(int size, uint64_t seed) {
  const TileNoise noise(seed);
  const auto leaf = [&](double u, double v) {
    const double bend = 0.03 * noise.at(v, u, 6);
    return 1 - noise.ridged(u + bend, v - bend, 14, 2);
  };
  return painted(
      "foliage", size, 0.75, leaf,
      [&](const Spot& s) {
        const double tone = 0.45 + 0.6 * noise.fractal(s.u, s.v, 5, 3);
        const glm::dvec3 green = mixed({58, 92, 38}, {142, 164, 66}, std::clamp(tone, 0.0, 1.0));
        return green * std::clamp(0.45 + 1.3 * s.height, 0.0, 1.15);
      },
      [](const Spot& s) { return 0.7 - 0.2 * s.height; });
}

SurfaceTextures make_grass(int size, uint64_t seed) {
  const TileNoise noise(seed);
  return painted(
      "grass", size, 0.4,
      [&](double u, double v) { return noise.fractal(u, v, 24, 4, 0.7) + 0.4 * noise.fractal(v, u, 5, 2); },
      [&](const Spot& s) {
        const double dry = smoothstep(-0.1, 0.5, noise.fractal(s.u, s.v, 4, 4, 0.5));
        const glm::dvec3 green = mixed({92, 118, 58}, {176, 166, 98}, 0.6 * dry);
        return green * (1 + 0.45 * s.height);
      },
      [](const Spot&) { return 0.93; });
}

}  // namespace gbl
