#include "renderer/normal_encoding.h"

#include <algorithm>
#include <cfloat>
#include <fmt/format.h>

#include "renderer/format.h"
#include "renderer/gbuffer_layout.h"
#include "renderer/random.h"
#include "tests/test_support.h"

namespace gbl {
namespace {

// Float noise of a decoded direction: a few roundings of 2^-24 radians each, in degrees.
constexpr double kFloatNoiseDeg = 1.5e-5;

const std::vector<glm::dvec3>& directions() {
  static const std::vector<glm::dvec3> all = fibonacci_sphere(1 << 20);
  return all;
}

// Where signs, seams, poles and folds of the encodings are.
std::vector<glm::dvec3> corner_cases() {
  std::vector<glm::dvec3> out;
  for (const double x : {-1.0, -0.5, -1e-9, -0.0, 0.0, 1e-9, 0.5, 1.0})
    for (const double y : {-1.0, -0.5, -1e-9, -0.0, 0.0, 1e-9, 0.5, 1.0})
      for (const double z : {-1.0, -0.5, -1e-9, -0.0, 0.0, 1e-9, 0.5, 1.0}) {
        const glm::dvec3 v(x, y, z);
        if (glm::length(v) > 0.1) out.push_back(glm::normalize(v));
      }
  return out;
}

double from_minus_z_deg(const glm::dvec3& n) { return angle_deg(n, {0, 0, -1}); }

template <class Check>
void for_each_encoding(Check check) {
  for (const ValueRow& r : rows<NormalEncoding>()) {
    SCOPED_TRACE(r.id);
    check(static_cast<NormalEncoding>(r.value));
  }
}

struct Errors {
  double mean_deg = 0, p99_deg = 0, max_deg = 0;
  std::vector<std::pair<double, glm::dvec3>> worst;  // the 1024 worst directions
};

template <class Store>
Errors measure(Store store, double cap_deg = 0) {
  std::vector<std::pair<double, int>> errors;
  errors.reserve(directions().size());
  Errors out;
  for (size_t i = 0; i < directions().size(); ++i) {
    const glm::dvec3& n = directions()[i];
    if (from_minus_z_deg(n) < cap_deg) continue;
    errors.emplace_back(angle_deg(n, store(n)), static_cast<int>(i));
    out.mean_deg += errors.back().first;
  }
  out.mean_deg /= static_cast<double>(errors.size());
  std::sort(errors.begin(), errors.end());
  out.p99_deg = errors[errors.size() * 99 / 100].first;
  out.max_deg = errors.back().first;
  for (auto e = errors.rbegin(); e != errors.rbegin() + 1024; ++e)
    out.worst.emplace_back(e->first, directions()[e->second]);
  return out;
}

// A grid of 2^20 directions misses the worst one by a few per cent: climb from the worst it has.
template <class Store>
double climbed(const Errors& errors, Store store) {
  Pcg32 random(1);
  double top = 0;
  for (auto [error, n] : errors.worst) {
    double step = 1e-3;  // the grid's spacing is 3.5e-3
    for (int failures = 0; step > 1e-8;) {
      const glm::dvec3 away(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1));
      const glm::dvec3 next = glm::normalize(n + step * away);
      const double next_error = angle_deg(next, store(next));
      if (next_error > error) {
        error = next_error;
        n = next;
        failures = 0;
      } else if (++failures > 30) {
        step /= 2;
        failures = 0;
      }
    }
    top = std::max(top, error);
  }
  return top;
}

std::string three_digits(double x) { return fmt::format("{:.2e}", x); }

TEST(NormalEncoding, ColumnsAreTheMeasuredErrors) {
  for_each_encoding([](NormalEncoding e) {
    const auto store = [e](const glm::dvec3& n) { return stored_normal_f64(e, n); };
    const Errors measured = measure(store);
    const EncodingRow& r = row_of(e);
    EXPECT_EQ(three_digits(measured.mean_deg), three_digits(r.mean_deg));
    EXPECT_EQ(three_digits(measured.p99_deg), three_digits(r.p99_deg));
    EXPECT_EQ(three_digits(climbed(measured, store)), three_digits(r.max_deg));
    EXPECT_LE(measured.max_deg, r.max_deg);
    EXPECT_GE(measured.max_deg, 0.98 * r.max_deg);
  });
}

TEST(NormalEncoding, RowsMatchTheirEnumAndFitTheirFormat) {
  for_each_encoding([](NormalEncoding e) {
    EXPECT_EQ(row_of(e).encoding, e);
    Settings s;
    s.normal.encoding = e;
    EXPECT_LE(row_of(e).bits, row(find(attachments(s), Stores::normal)->format).bytes * 8);
    EXPECT_TRUE(contains(row(e).cost, fmt::format("{}", row_of(e).bits))) << row(e).cost;
  });
}

TEST(NormalEncoding, FloatIsAsGoodAsDouble) {
  for_each_encoding([](NormalEncoding e) {
    // 0.1 degrees round -Z are left out for the float stereographic code: 1 + z has lost its digits there.
    const double cap_deg = e == NormalEncoding::stereo16f ? 0.1 : 0;
    const Errors measured = measure([e](const glm::dvec3& n) { return stored_normal_f32(e, glm::vec3(n)); }, cap_deg);
    const EncodingRow& r = row_of(e);
    // Half a digit of the column's three, and what float arithmetic adds.
    EXPECT_NEAR(measured.mean_deg, r.mean_deg, 0.005 * r.mean_deg);
    EXPECT_NEAR(measured.p99_deg, r.p99_deg, 0.005 * r.p99_deg);
    EXPECT_LE(measured.max_deg, r.max_deg + kFloatNoiseDeg);
  });
}

TEST(NormalEncoding, FloatChoosesTheSameCodeAsDouble) {
  for_each_encoding([](NormalEncoding e) {
    int other_code = 0;
    for (const glm::dvec3& n : directions())
      if (!(e == NormalEncoding::stereo16f && from_minus_z_deg(n) < 0.1))
        other_code +=
            angle_deg(glm::dvec3(stored_normal_f32(e, glm::vec3(n))), stored_normal_f64(e, n)) > kFloatNoiseDeg;
    // Float moves a value by 2^-24 of full scale, 0.004 of a 16-bit step: so few fall on the other side of a rounding.
    EXPECT_LE(other_code, 0.01 * static_cast<double>(directions().size()));
  });
}

TEST(NormalEncoding, DecodedNormalsAreUnit) {
  for_each_encoding([](NormalEncoding e) {
    double worst_f64 = 0, worst_f32 = 0;
    for (size_t i = 0; i < directions().size(); i += 8) {
      const glm::dvec3& n = directions()[i];
      worst_f64 = std::max(worst_f64, std::abs(glm::length(stored_normal_f64(e, n)) - 1));
      worst_f32 = std::max(worst_f32, std::abs(glm::length(glm::dvec3(stored_normal_f32(e, glm::vec3(n)))) - 1));
    }
    EXPECT_LE(worst_f64, 4 * DBL_EPSILON);
    EXPECT_LE(worst_f32, 4 * FLT_EPSILON);
  });
}

TEST(NormalEncoding, CornerCasesAreWithinTheColumnInBothBuilds) {
  for_each_encoding([](NormalEncoding e) {
    for (const glm::dvec3& n : corner_cases()) {
      if (e == NormalEncoding::stereo16f && from_minus_z_deg(n) < 0.1) continue;  // its own test below
      EXPECT_LE(angle_deg(n, stored_normal_f64(e, n)), row_of(e).max_deg) << n.x << " " << n.y << " " << n.z;
      EXPECT_LE(angle_deg(n, glm::dvec3(stored_normal_f32(e, glm::vec3(n)))), row_of(e).max_deg + kFloatNoiseDeg)
          << n.x << " " << n.y << " " << n.z;
    }
  });
}

TEST(NormalEncoding, TheLowerHalfKeepsItsSign) {
  for_each_encoding([](NormalEncoding e) {
    for (size_t i = 0; i < directions().size(); i += 4) {
      const glm::dvec3& n = directions()[i];
      if (n.z > -0.05) continue;  // 2.9 degrees below the equator: more than any encoding's error
      const glm::dvec3 stored = stored_normal_f64(e, n);
      ASSERT_LT(stored.z, 0) << n.x << " " << n.y << " " << n.z;
      ASSERT_LE(angle_deg(n, stored), row_of(e).max_deg) << n.x << " " << n.y << " " << n.z;
    }
  });
}

TEST(NormalEncoding, OctahedralAxesAreExact) {
  for (const NormalEncoding e : {NormalEncoding::oct16, NormalEncoding::oct8})
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {1.0, -1.0})
        for (const double zero : {0.0, -0.0}) {
          glm::dvec3 n(zero);
          n[axis] = sign;
          EXPECT_EQ(stored_normal_f64(e, n), n) << axis << " " << sign;
          EXPECT_EQ(stored_normal_f32(e, glm::vec3(n)), glm::vec3(n)) << axis << " " << sign;
        }
}

TEST(NormalEncoding, ASecondStoreChangesNothingButForXyz8) {
  for_each_encoding([](NormalEncoding e) {
    size_t moved = 0;
    for (const glm::dvec3& n : directions()) {
      const glm::dvec3 once = stored_normal_f64(e, n);
      moved += !(angle_deg(once, stored_normal_f64(e, once)) <= 1e-12);  // rounding of the decoder alone
    }
    const double share = static_cast<double>(moved) / static_cast<double>(directions().size());
    // n * 0.5 + 0.5 has codes longer and shorter than 1; normalised, 1.9 % round to another code.
    if (e == NormalEncoding::xyz8) {
      EXPECT_NEAR(share, 0.0193, 0.0005);
    } else {
      EXPECT_EQ(share, 0);
    }
  });
}

TEST(Stereographic, HasNoCodeForMinusZAndForNoOtherDirection) {
  const auto finite = [](const auto& n) { return std::isfinite(n.x) && std::isfinite(n.y) && std::isfinite(n.z); };
  const auto tilted = [](double deg) {
    return glm::dvec3(std::sin(glm::radians(deg)), 0, -std::cos(glm::radians(deg)));
  };
  constexpr NormalEncoding kStereo = NormalEncoding::stereo16f;
  EXPECT_FALSE(finite(stored_normal_f64(kStereo, {0, 0, -1})));
  EXPECT_FALSE(finite(stored_normal_f32(kStereo, {0, 0, -1})));
  for (const glm::dvec3& n : directions()) ASSERT_TRUE(finite(stored_normal_f64(kStereo, n)));
  // The code is 2 / angle; half floats end at 65520: 0.00175 degrees. Closer, the store overflows, not the formula.
  EXPECT_TRUE(finite(stored_normal_f64(kStereo, tilted(0.00176))));
  EXPECT_FALSE(finite(stored_normal_f64(kStereo, tilted(0.00174))));
  // In float 1 + z is 0 within acos(1 - 2^-25) = 0.0140 degrees.
  EXPECT_TRUE(finite(stored_normal_f32(kStereo, glm::vec3(tilted(0.0141)))));
  EXPECT_FALSE(finite(stored_normal_f32(kStereo, glm::vec3(tilted(0.0139)))));
  EXPECT_FALSE(row(kStereo).sound());
}

TEST(AngleDeg, IsExactForSmallAnglesToo) {
  for (const double deg : {1e-10, 1e-6, 0.1, 45.0, 90.0, 179.9}) {
    const glm::dvec3 b(std::cos(glm::radians(deg)), std::sin(glm::radians(deg)), 0);
    EXPECT_NEAR(angle_deg({1, 0, 0}, b), deg, 1e-12 * deg + 1e-14);
  }
  EXPECT_EQ(angle_deg({1, 0, 0}, {1, 0, 0}), 0);
  EXPECT_DOUBLE_EQ(angle_deg({1, 0, 0}, {-1, 0, 0}), 180);
}

}  // namespace
}  // namespace gbl
