// `light-drift` and `light-moved-in-draw` (nclgl tutorial 15, DrawPointLights, lines 210-217): positions that are turned in
// place in each frame. The lab's are functions of time.
#include <cmath>
#include <gtest/gtest.h>

#include "renderer/light/lights.h"

namespace gbl {
namespace {

constexpr LightGrid kGrid{.extent = {4112, 4112}, .height = 100, .pivot = {2056, 2056}, .degrees_per_s = 10};
constexpr double kRange = 514;

// How far the corner light of source 0 is from where it was, an hour and a hundred whole turns later, when its matrices
// are multiplied in float: push * rotation * pop * translation.
double drift_after_an_hour(int frames_per_s) {
  const float angle = glm::radians(10.0f / float(frames_per_s)), c = std::cos(angle), s = std::sin(angle);
  const auto turned = [&](glm::vec2 p) { return glm::vec2(c * p.x + s * p.y, -s * p.x + c * p.y); };
  const glm::vec2 start(0, 0), pivot(2056, 2056), moved = turned(-pivot) + pivot;
  glm::vec2 p = start;
  for (int i = 0; i < 3600 * frames_per_s; ++i) p = turned(p) + moved;
  return double(glm::distance(p, start));
}

TEST(LightDrift, TurnedInPlaceLightsLeaveTheirPlace) {
  RecordProperty("units_at_60_hz", std::to_string(drift_after_an_hour(60)));
  RecordProperty("units_at_144_hz", std::to_string(drift_after_an_hour(144)));
  EXPECT_GT(drift_after_an_hour(60), 1);
  EXPECT_GT(drift_after_an_hour(144), 1);
}

TEST(LightDrift, LightsOfAbsoluteTimeDoNot) {
  const Light first = generated_lights(kGrid, 64, 1, 0)[0], later = generated_lights(kGrid, 64, 1, 3600)[0];
  const glm::dvec3 pivot(2056, 100, 2056);
  EXPECT_NEAR(glm::distance(first.position, pivot), glm::distance(later.position, pivot), 1e-9 * kRange);
  EXPECT_NEAR(glm::distance(first.position, later.position), 0, 1e-6) << "an hour is a hundred whole turns";
}

TEST(LightMovedInDraw, DrawingTwiceMovesNothing) {
  const auto once = generated_lights(kGrid, 64, 1, 12.5), twice = generated_lights(kGrid, 64, 1, 12.5);
  for (size_t i = 0; i < once.size(); ++i) EXPECT_EQ(once[i].position, twice[i].position);
}

}  // namespace
}  // namespace gbl
