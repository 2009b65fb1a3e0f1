#include "renderer/scenes/procedural_texture.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gbl {
namespace {

TEST(ProceduralTexture, TilesWithoutASeam) {
  const GroundTextures ground = make_ground_textures(256, 15);
  for (const Texture& t : {ground.albedo, ground.normal, ground.wetness, make_stone_albedo(256, 3)}) {
    const auto step = [&t](int x0, int y0, int x1, int y1) {
      double sum = 0;
      for (int c = 0; c < 3; ++c)
        sum += std::abs(t.rgba[(y0 * t.size.x + x0) * 4 + c] - t.rgba[(y1 * t.size.x + x1) * 4 + c]);
      return sum;
    };
    const int n = t.size.x;
    const auto across = [&](int x) {  // from column x to the next
      double sum = 0;
      for (int y = 0; y < n; ++y) sum += step(x, y, (x + 1) % n, y);
      return sum;
    };
    const auto down = [&](int y) {
      double sum = 0;
      for (int x = 0; x < n; ++x) sum += step(x, y, x, (y + 1) % n);
      return sum;
    };
    double worst_across = 0, worst_down = 0;
    for (int i = 0; i + 1 < n; ++i) {
      worst_across = std::max(worst_across, across(i));
      worst_down = std::max(worst_down, down(i));
    }
    EXPECT_LE(across(n - 1), worst_across) << t.name;  // the seam is no rougher than the roughest place inside
    EXPECT_LE(down(n - 1), worst_down) << t.name;
  }
}

TEST(ProceduralTexture, GroundIsBumpyReddishAndPartlyWet) {
  const GroundTextures t = make_ground_textures(256, 15);
  double square_tilt = 0, wet = 0, dry = 0;
  glm::dvec3 mean(0);
  const size_t count = 256 * 256;
  for (size_t i = 0; i < count * 4; i += 4) {
    const glm::dvec3 n = glm::dvec3(t.normal.rgba[i], t.normal.rgba[i + 1], t.normal.rgba[i + 2]) / 127.5 - 1.0;
    EXPECT_NEAR(glm::length(n), 1, 0.012);
    const double tilt = glm::degrees(std::atan2(std::hypot(n.x, n.y), n.z));
    square_tilt += tilt * tilt / count;
    mean += glm::dvec3(t.albedo.rgba[i], t.albedo.rgba[i + 1], t.albedo.rgba[i + 2]) / static_cast<double>(count);
    const double roughness = t.wetness.rgba[i + 1] / 255.0;
    wet += roughness < 0.45 ? 1.0 / count : 0;  // puddles are 0.34, dry earth 0.8
    dry += roughness > 0.65 ? 1.0 / count : 0;
  }
  EXPECT_NEAR(std::sqrt(square_tilt), 12.5, 2.5);
  EXPECT_LT(glm::distance(mean, glm::dvec3(150, 110, 80)), 12);
  EXPECT_GT(wet, 0.05);
  EXPECT_LT(wet, 0.4);
  EXPECT_GT(dry, 0.5);
}

TEST(ProceduralTexture, NormalsLeanAwayFromTheCrest) {
  // One crest along x = 4: left of it normals lean left; and one along row 2: rows above it lean up, green > half.
  ScalarMap across{8, std::vector<double>(64, 0)}, along = across;
  for (size_t i = 0; i < 8; ++i) across.texels[i * 8 + 4] = along.texels[2 * 8 + i] = 1;
  const Texture a = normal_map("a", across, 0.3), b = normal_map("b", along, 0.3);
  EXPECT_LT(a.rgba[3 * 4], 100);
  EXPECT_GT(a.rgba[5 * 4], 155);
  EXPECT_GT(b.rgba[1 * 8 * 4 + 1], 155);
  EXPECT_LT(b.rgba[3 * 8 * 4 + 1], 100);
}

}  // namespace
}  // namespace gbl
