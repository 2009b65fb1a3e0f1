// Every row of the encodings' table, in both arithmetics and both roundings.
#include "renderer/gbuffer/normal_encoding.h"

#include <cfloat>
#include <fmt/format.h>
#include <glm/gtc/packing.hpp>

#include "renderer/frame/attachments.h"
#include "tests/gbuffer/normal_errors.h"

namespace gbl {
namespace {

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

template <class Check>
void for_each_encoding(Check check) {
  for (const ValueRow& r : rows<NormalEncoding>()) {
    SCOPED_TRACE(r.id);
    check(static_cast<NormalEncoding>(r.value));
  }
}

std::string three_digits(double x) { return fmt::format("{:.3g}", x); }

void expect_measured(const Degrees& column, NormalEncoding e, StoreRounding rounding) {
  const auto store = [&](const glm::dvec3& n) { return stored_normal(e, n, rounding); };
  const Errors found = measure(store);
  EXPECT_EQ(three_digits(found.degrees.mean), three_digits(column.mean));
  EXPECT_EQ(three_digits(found.degrees.p99), three_digits(column.p99));
  // A bound, and one that is reached; 5 % because the worst spots of lambert16 and of the floats are smaller than what
  // climbing hits.
  const double top = climbed(found, store);
  EXPECT_LE(top, kHalfADigit * column.max);
  EXPECT_GE(top, 0.95 * column.max);
}

TEST(NormalEncoding, ColumnsAreTheMeasuredErrors) {
  for_each_encoding([](NormalEncoding e) { expect_measured(row_of(e).error, e, StoreRounding::to_nearest); });
}

TEST(NormalEncoding, FloatColumnsTowardZeroAreTheMeasuredErrors) {
  for_each_encoding([](NormalEncoding e) {
    ASSERT_EQ(row_of(e).toward_zero.has_value(), !row_of(e).whole_codes());
    if (row_of(e).toward_zero) expect_measured(*row_of(e).toward_zero, e, StoreRounding::toward_zero);
  });
}

TEST(NormalEncoding, RowsMatchTheirEnumAndFitTheirFormat) {
  for_each_encoding([](NormalEncoding e) {
    const EncodingRow& r = row_of(e);
    EXPECT_EQ(row(e).sound(), r.lost == nullptr);
    Settings s;
    s.normal.encoding = e;
    EXPECT_EQ(find(attachments(s), Stores::normal)->format, r.format);
    EXPECT_LE(r.bits(), row(r.format).bytes * 8);
    if (r.storage() != NormalStorage::word) {
      EXPECT_EQ(r.bits_per_channel * row(r.format).channels, row(r.format).bytes * 8);
      EXPECT_LE(r.channels, row(r.format).channels);
    }
    EXPECT_TRUE(contains(row(e).cost, fmt::format("{} bits", row(r.format).bytes * 8))) << row(e).cost;
    EXPECT_TRUE(contains(row(e).cost, fmt::format("{}", r.bits()))) << row(e).cost;
  });
}

TEST(NormalEncoding, CodesAreWholeNumbersOfTheirBitsAndLeaveUnusedChannelsZero) {
  for_each_encoding([](NormalEncoding e) {
    const EncodingRow& r = row_of(e);
    const double largest = std::ldexp(1.0, r.bits_per_channel) - 1;
    int bad = 0;
    const auto judge = [&](const glm::dvec3& code) {
      for (int k = 0; k < 3; ++k)
        if (k >= r.channels)
          bad += code[k] != 0;
        else if (r.whole_codes())
          bad += !(code[k] == std::floor(code[k]) && code[k] >= 0 && code[k] <= largest);
    };
    for (const glm::dvec3& n : corner_cases()) judge(stored_code(e, n)), judge(stored_code(e, glm::vec3(n)));
    for (size_t i = 0; i < directions().size(); i += 16) judge(stored_code(e, directions()[i]));
    EXPECT_EQ(bad, 0);
  });
}

TEST(NormalEncoding, FloatIsAsGoodAsDouble) {
  for_each_encoding([](NormalEncoding e) {
    const auto left_out = [e](const glm::dvec3& n) { return lost(e, n); };
    const Degrees f64 = measure([e](const glm::dvec3& n) { return stored_normal(e, n); }, left_out).degrees;
    const Degrees f32 = measure([e](const glm::dvec3& n) { return stored_normal(e, glm::vec3(n)); }, left_out).degrees;
    // Half a digit of the column's three, and what float arithmetic adds.
    EXPECT_NEAR(f32.mean, f64.mean, 0.005 * f64.mean);
    EXPECT_NEAR(f32.p99, f64.p99, 0.005 * f64.p99);
    EXPECT_LE(f32.max, kHalfADigit * row_of(e).error.max + kFloatNoiseDeg);
  });
}

TEST(NormalEncoding, FloatChoosesTheSameCodeAsDouble) {
  for_each_encoding([](NormalEncoding e) {
    int other_code = 0;
    for (const glm::dvec3& n : directions())
      if (!lost(e, n)) other_code += glm::dvec3(stored_code(e, glm::vec3(n))) != stored_code(e, n);
    // Float moves a value by 2^-24 of full scale, 0.004 of a 16-bit step: so few fall on the other side of a rounding.
    // Of the 64 lengths that bestfit8 tries, 3 % of the best have a rival as good to float's digits.
    const double share = e == NormalEncoding::bestfit8 ? 0.04 : 0.01;
    EXPECT_LE(other_code, share * static_cast<double>(directions().size()));
  });
}

TEST(NormalEncoding, DecodedNormalsAreUnit) {
  for_each_encoding([](NormalEncoding e) {
    double worst_f64 = 0, worst_f32 = 0;
    for (size_t i = 0; i < directions().size(); i += 8) {
      const glm::dvec3& n = directions()[i];
      worst_f64 = std::max(worst_f64, std::abs(glm::length(stored_normal(e, n)) - 1));
      worst_f32 = std::max(worst_f32, std::abs(glm::length(glm::dvec3(stored_normal(e, glm::vec3(n)))) - 1));
    }
    // What is stored in floats and not normalised again is as far off as its three roundings, whatever decodes it.
    EXPECT_LE(worst_f64, row_of(e).format == Format::rgba32f ? FLT_EPSILON : 4 * DBL_EPSILON);
    EXPECT_LE(worst_f32, 4 * FLT_EPSILON);
  });
}

TEST(NormalEncoding, CornerCasesAreWithinTheColumnInBothBuilds) {
  for_each_encoding([](NormalEncoding e) {
    for (const glm::dvec3& n : corner_cases()) {
      if (lost(e, n)) continue;
      const double bound = kHalfADigit * row_of(e).error.max;
      EXPECT_LE(angle_deg(n, stored_normal(e, n)), bound) << n.x << " " << n.y << " " << n.z;
      EXPECT_LE(angle_deg(n, glm::dvec3(stored_normal(e, glm::vec3(n)))), bound + kFloatNoiseDeg)
          << n.x << " " << n.y << " " << n.z;
    }
  });
}

TEST(NormalEncoding, TheLowerHalfKeepsItsSign) {
  for_each_encoding([](NormalEncoding e) {
    for (size_t i = 0; i < directions().size(); i += 4) {
      const glm::dvec3& n = directions()[i];
      if (n.z > -0.05 || lost(e, n)) continue;  // 2.9 degrees below the equator: more than any encoding's error
      const glm::dvec3 stored = stored_normal(e, n);
      ASSERT_LT(stored.z, 0) << n.x << " " << n.y << " " << n.z;
      ASSERT_LE(angle_deg(n, stored), kHalfADigit * row_of(e).error.max) << n.x << " " << n.y << " " << n.z;
    }
  });
}

TEST(NormalEncoding, AxesAreExactWhereZeroHasACode) {
  using enum NormalEncoding;
  for (const NormalEncoding e :
       {xyz10, xyz16f, xyz32f, bestfit8, spherical16, oct8, oct10, oct12, oct14, oct16, oct16_precise}) {
    SCOPED_TRACE(row(e).id);
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {1.0, -1.0})
        for (const double zero : {0.0, -0.0}) {
          glm::dvec3 n(zero);
          n[axis] = sign;
          EXPECT_EQ(stored_normal(e, n), n) << axis << " " << sign;
          EXPECT_EQ(stored_normal(e, glm::vec3(n)), glm::vec3(n)) << axis << " " << sign;
        }
  }
}

// The share of directions that a second store moves.
double moved_again(NormalEncoding e) {
  size_t moved = 0;
  for (const glm::dvec3& n : directions()) {
    const glm::dvec3 once = stored_normal(e, n);
    moved += !(angle_deg(once, stored_normal(e, once)) <= 1e-12);  // rounding of the decoder alone
  }
  return static_cast<double>(moved) / static_cast<double>(directions().size());
}

TEST(NormalEncoding, ASecondStoreChangesNothingWhereTwoNumbersAreStored) {
  for_each_encoding([](NormalEncoding e) {
    if (!row(e).sound() && e != NormalEncoding::stereo16f) return;
    // Three numbers hold codes longer and shorter than 1; normalised, a few round to another code.
    EXPECT_LE(moved_again(e), row_of(e).channels == 2 ? 0 : 0.02);
  });
  EXPECT_NEAR(moved_again(NormalEncoding::xyz8), 0.0193, 0.0005);
  EXPECT_EQ(moved_again(NormalEncoding::bestfit8), 0) << "the code that fits best fits itself best";
  EXPECT_EQ(moved_again(NormalEncoding::xyz32f), 0) << "what was read is what was stored";
}

// By neighbours: both results are halves, none lies between them, and the nearer one is taken.
TEST(NormalEncoding, HalvesAreRoundedAsAsked) {
  const auto is_half = [](double x) { return glm::unpackHalf1x16(glm::packHalf1x16(static_cast<float>(x))) == x; };
  for (size_t i = 0; i < directions().size(); i += 64)
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3& n = directions()[i];
      if (n[k] == 0) continue;
      const double near = stored_code(NormalEncoding::xyz16f, n)[k];
      const double cut = stored_code(NormalEncoding::xyz16f, n, StoreRounding::toward_zero)[k];
      const double beyond = std::nextafter(static_cast<float>(cut), 2 * static_cast<float>(n[k]));
      const double next = cut + std::copysign(std::ldexp(1.0, std::max(std::ilogb(cut), -14) - 10), n[k]);
      ASSERT_TRUE(is_half(near) && is_half(cut) && is_half(next)) << n[k];
      ASSERT_FALSE(is_half(beyond)) << n[k];
      ASSERT_LE(std::abs(cut), std::abs(n[k]));
      ASSERT_GT(std::abs(next), std::abs(n[k]));
      ASSERT_TRUE(near == cut || near == next) << n[k];
      ASSERT_EQ(std::abs(n[k] - near), std::min(std::abs(n[k] - cut), std::abs(next - n[k]))) << n[k];
    }
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
