// What is said of single normal encodings: where they fail, and why some are better than others.
#include <cmath>

#include "tests/gbuffer/normal_errors.h"

namespace gbl {
namespace {

TEST(Stereographic, HasNoCodeForMinusZAndForNoOtherDirection) {
  const auto finite = [](const auto& n) { return std::isfinite(n.x) && std::isfinite(n.y) && std::isfinite(n.z); };
  const auto tilted = [](double deg) {
    return glm::dvec3(std::sin(glm::radians(deg)), 0, -std::cos(glm::radians(deg)));
  };
  constexpr NormalEncoding kStereo = NormalEncoding::stereo16f;
  EXPECT_FALSE(finite(stored_normal(kStereo, glm::dvec3(0, 0, -1))));
  EXPECT_FALSE(finite(stored_normal(kStereo, glm::vec3(0, 0, -1))));
  for (const glm::dvec3& n : directions()) ASSERT_TRUE(finite(stored_normal(kStereo, n)));
  // The code is 2 / angle; half floats end at 65520: 0.00175 degrees. Closer, the store overflows, not the formula;
  // a store that truncates stops at 65504.
  EXPECT_TRUE(finite(stored_normal(kStereo, tilted(0.00176))));
  EXPECT_FALSE(finite(stored_normal(kStereo, tilted(0.00174))));
  EXPECT_EQ(stored_code(kStereo, tilted(0.00174), StoreRounding::toward_zero).x, 65504);
  // In float 1 + z is 0 within acos(1 - 2^-25) = 0.0140 degrees.
  EXPECT_TRUE(finite(stored_normal(kStereo, glm::vec3(tilted(0.0141)))));
  EXPECT_FALSE(finite(stored_normal(kStereo, glm::vec3(tilted(0.0139)))));
}

// The hemisphere that faces a viewer on +Z, as the source's view-space normals.
template <class Store>
Errors measure_facing(Store store) {
  return measure(store, [](const glm::dvec3& n) { return n.z < 0; });
}

TEST(Xyz8Raw, LosesWhatIsNegative) {
  constexpr NormalEncoding kRaw = NormalEncoding::xyz8_raw;
  const auto store = [](const glm::dvec3& n) { return stored_normal(kRaw, n); };
  const Errors facing = measure_facing(store);
  EXPECT_NEAR(facing.degrees.mean, 30.7, 0.05);
  EXPECT_NEAR(facing.degrees.max, 90, 0.2);
  size_t wrong = 0, all = 0;
  for (const glm::dvec3& n : directions())
    if (n.z > 0) ++all, wrong += angle_deg(n, store(n)) > 1;
  EXPECT_NEAR(static_cast<double>(wrong) / static_cast<double>(all), 0.74, 0.005);
  const auto lost_here = [](const glm::dvec3& n) { return lost(kRaw, n); };
  EXPECT_LE(measure(store, lost_here).degrees.max, row_of(NormalEncoding::xyz8).error.max) << "the positive octant";
  for (const glm::dvec3& n : {glm::dvec3(-1, 0, 0), glm::dvec3(-0.6, -0.0, -0.8), glm::normalize(glm::dvec3(-1))}) {
    EXPECT_EQ(stored_normal(kRaw, n), glm::dvec3(0, 0, 1)) << "nothing is left: +Z, not a NaN";
    EXPECT_EQ(stored_normal(kRaw, glm::vec3(n)), glm::vec3(0, 0, 1));
  }
}

TEST(XySqrt, MirrorsWhatFacesAway) {
  constexpr NormalEncoding kXy = NormalEncoding::xy_sqrt;
  const auto store = [](const glm::dvec3& n) { return stored_normal(kXy, n); };
  const Errors facing = measure_facing(store);
  EXPECT_NEAR(facing.degrees.mean, 0.0386, 0.0001);
  // z has no digits left where x^2 + y^2 is all but 1: half a step off in both is sqrt(2 sqrt(2) / 4094) radians.
  EXPECT_NEAR(facing.degrees.max, 1.505, 0.1);
  for (size_t i = 0; i < directions().size(); i += 16) {
    const glm::dvec3& n = directions()[i];
    if (n.z >= 0) continue;
    const double mirrored_deg = 2 * glm::degrees(std::asin(-n.z));
    ASSERT_NEAR(angle_deg(n, store(n)), mirrored_deg, 1.51) << n.z;
    ASSERT_GE(store(n).z, 0);
  }
  EXPECT_EQ(angle_deg({0, 0, -1}, store({0, 0, -1})), 180);
}

TEST(Oct16Precise, IsNeverWorseThanOct16) {
  double mean = 0, mean_precise = 0;
  for (const glm::dvec3& n : directions()) {
    const double plain = angle_deg(n, stored_normal(NormalEncoding::oct16, n));
    const double precise = angle_deg(n, stored_normal(NormalEncoding::oct16_precise, n));
    ASSERT_LE(precise, plain + 1e-12) << n.x << " " << n.y << " " << n.z;
    mean += plain, mean_precise += precise;
    const glm::vec3 f(n);  // chosen in float: as good to float noise
    ASSERT_LE(angle_deg(n, glm::dvec3(stored_normal(NormalEncoding::oct16_precise, f))),
              angle_deg(n, glm::dvec3(stored_normal(NormalEncoding::oct16, f))) + kFloatNoiseDeg);
  }
  EXPECT_LT(mean_precise, 0.95 * mean);
  EXPECT_LT(row_of(NormalEncoding::oct16_precise).error.max, 0.7 * row_of(NormalEncoding::oct16).error.max);
}

TEST(Bestfit8, FindsTheBestOfAllLengths) {
  const Degrees& best = row_of(NormalEncoding::bestfit8).error;
  const Degrees& plain = row_of(NormalEncoding::xyz8).error;
  EXPECT_LT(best.mean, 0.2 * plain.mean);
  EXPECT_LT(best.p99, 0.5 * plain.p99);
  EXPECT_LT(best.max, plain.max);
  for (size_t i = 0; i < directions().size(); i += 128) {
    const glm::dvec3& n = directions()[i];
    const double longest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
    double least_deg = 180;
    for (int steps = 1; steps <= 127; ++steps)
      least_deg = std::min(least_deg, angle_deg(n, glm::normalize(glm::round(n * (steps / longest)))));
    // 1e-13 in the squared sine is what the search takes for a tie: 1.9e-5 degrees.
    ASSERT_NEAR(angle_deg(n, stored_normal(NormalEncoding::bestfit8, n)), least_deg, 2e-5) << i;
  }
}

TEST(Lambert16, ThePoleHasACode) {
  constexpr NormalEncoding kLambert = NormalEncoding::lambert16;
  for (const double x : {0.0, -0.0, 1e-9, -1e-9, 1e-18, 1e-30})
    for (const double y : {0.0, -0.0, 1e-9, -1e-9, 1e-18, 1e-30}) {
      const glm::dvec3 n = glm::normalize(glm::dvec3(x, y, -1));
      EXPECT_LE(angle_deg({0, 0, -1}, stored_normal(kLambert, n)), row_of(kLambert).error.max) << x << " " << y;
      EXPECT_LE(angle_deg({0, 0, -1}, glm::dvec3(stored_normal(kLambert, glm::vec3(n)))), row_of(kLambert).error.max);
    }
  EXPECT_EQ(stored_code(kLambert, glm::dvec3(0, 0, -1)), glm::dvec3(65534, 32767, 0));
  EXPECT_EQ(stored_normal(kLambert, glm::dvec3(0, 0, -1)), glm::dvec3(0, 0, -1));
  EXPECT_EQ(stored_normal(kLambert, glm::vec3(-0.0f, 0, -1)), glm::vec3(0, 0, -1));
}

TEST(Spherical16, TheSeamHasOneCodeAndPolesNeedNoAzimuth) {
  constexpr NormalEncoding kSpherical = NormalEncoding::spherical16;
  for (const double y : {0.0, -0.0, 1e-9, -1e-9})
    EXPECT_EQ(stored_code(kSpherical, glm::normalize(glm::dvec3(-1, y, 0))), glm::dvec3(0, 32767, 0)) << y;
  for (const double z : {1.0, -1.0})
    for (const double x : {0.0, -0.0})
      for (const double y : {0.0, -0.0}) EXPECT_EQ(stored_normal(kSpherical, glm::dvec3(x, y, z)), glm::dvec3(0, 0, z));
}

}  // namespace
}  // namespace gbl
