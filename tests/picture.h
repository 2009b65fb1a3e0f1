#pragma once
// Pictures of float texels for the tests, and the one way to compare them: two tolerances and a reason. What
// fails a test is written as a PNG into the folder `differences` of the build.
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <glm/glm.hpp>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "renderer/base/files.h"
#include "renderer/picture/image.h"
#include "tests/test_paths.h"

namespace gbl::test {

struct Picture {
  glm::ivec2 size{0};
  std::vector<glm::vec4> texels;  // rows bottom to top, as GL has them
  size_t count() const { return texels.size(); }
};

struct Tolerance {
  double max_abs = 0;           // of a channel; a texel beyond it fails
  double failing_fraction = 0;  // share of texels that may fail
  const char* why = "";         // the reason for both, printed on failure
};

struct Difference {
  double max_abs = 0;  // infinite where only one of the two is finite
  size_t failing = 0, worst = 0;
};

// Two non-finite values are equal if they are both NaN or the same infinity; else the difference is infinite.
inline double channel_difference(float a, float b) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
  const double d = std::abs(double(a) - double(b));
  return std::isfinite(d) ? d : INFINITY;
}

inline Difference difference(const Picture& got, const Picture& expected, double max_abs) {
  Difference out;
  for (size_t i = 0; i < got.count(); ++i) {
    double d = 0;
    for (int k = 0; k < 4; ++k) d = std::max(d, channel_difference(got.texels[i][k], expected.texels[i][k]));
    if (d > out.max_abs) out.max_abs = d, out.worst = i;
    if (d > max_abs) ++out.failing;
  }
  return out;
}

// Red where there is too much, blue where there is too little, magenta where only one is finite; scaled to the worst.
inline Image difference_image(const Picture& got, const Picture& expected) {
  double scale = 0;
  const auto signed_of = [&](size_t i, int k) { return double(got.texels[i][k]) - double(expected.texels[i][k]); };
  for (size_t i = 0; i < got.count(); ++i)
    for (int k = 0; k < 4; ++k)
      if (std::isfinite(signed_of(i, k))) scale = std::max(scale, std::abs(signed_of(i, k)));
  std::vector<uint8_t> rgba;
  for (size_t i = 0; i < got.count(); ++i) {
    double more = 0, less = 0;
    for (int k = 0; k < 4; ++k) {
      const bool odd = channel_difference(got.texels[i][k], expected.texels[i][k]) == INFINITY;
      const double d = odd ? scale : std::isfinite(signed_of(i, k)) ? signed_of(i, k) : 0;
      more = std::max(more, d), less = std::max(less, odd ? scale : -d);
    }
    const auto code = [&](double d) { return static_cast<uint8_t>(scale > 0 ? 255 * d / scale : d > 0 ? 255 : 0); };
    rgba.insert(rgba.end(), {code(more), 0, code(less), 255});
  }
  return image_from_gl_rows(got.size, std::move(rgba));
}

inline std::filesystem::path write_difference(const Picture& got, const Picture& expected) {
  static int number = 0;
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path folder = build_folder() / "differences";
  make_folder(folder);
  auto path = folder / fmt::format("{}.{}.{}.png", test->test_suite_name(), test->name(), ++number);
  write_png(path, difference_image(got, expected));
  return path;
}

// What tells the two apart beyond the tolerance; empty: nothing.
inline std::string told_apart(const Picture& got, const Picture& expected, const Tolerance& t) {
  if (got.size != expected.size)
    return fmt::format("{}x{} is not the size {}x{}", got.size.x, got.size.y, expected.size.x, expected.size.y);
  const Difference d = difference(got, expected, t.max_abs);
  if (double(d.failing) <= t.failing_fraction * double(got.count())) return "";
  const glm::vec4 g = got.texels[d.worst], e = expected.texels[d.worst];
  return fmt::format(
      "{} of {} texels differ by more than {:g}, the worst by {:g} at ({}, {} from below): ({}, {}, {}, {}) is not "
      "({}, {}, {}, {}). The tolerance's reason: {}",
      d.failing, got.count(), t.max_abs, d.max_abs, int(d.worst) % got.size.x, int(d.worst) / got.size.x, g.x, g.y, g.z,
      g.w, e.x, e.y, e.z, e.w, t.why);
}

// For pictures that must agree: a difference is written as a picture. Where one is expected, ask `unlike`.
inline ::testing::AssertionResult like(const Picture& got, const Picture& expected, const Tolerance& t) {
  const std::string difference = told_apart(got, expected, t);
  if (difference.empty()) return ::testing::AssertionSuccess();
  auto failure = ::testing::AssertionFailure() << difference;
  if (got.size == expected.size) failure << ". Difference: " << write_difference(got, expected).string();
  return failure;
}

// For pictures that must differ; writes nothing.
inline ::testing::AssertionResult unlike(const Picture& got, const Picture& expected, const Tolerance& t) {
  const std::string difference = told_apart(got, expected, t);
  if (!difference.empty()) return ::testing::AssertionSuccess() << difference;
  return ::testing::AssertionFailure() << fmt::format("nothing differs by more than {:g}", t.max_abs);
}

// Not one bit differs (NaNs and the sign of 0 included).
inline ::testing::AssertionResult same_bits(const Picture& got, const Picture& expected) {
  const bool same = got.size == expected.size &&
                    std::memcmp(got.texels.data(), expected.texels.data(), got.count() * sizeof(glm::vec4)) == 0;
  if (same) return ::testing::AssertionSuccess();
  auto result = like(got, expected, {.why = "the same bits are demanded"});
  return result ? ::testing::AssertionFailure() << "equal values, but not the same bits" : result;
}

inline size_t nonfinite(const Picture& p) {
  size_t n = 0;
  for (const glm::vec4& t : p.texels) n += !(std::isfinite(t.x + t.y + t.z + t.w));
  return n;
}

}  // namespace gbl::test
