#include "renderer/truth/colour_spaces.h"

#include <gtest/gtest.h>

namespace gbl {
namespace {

TEST(ColourSpaces, AgreeWithPublishedNumbers) {
  const glm::dvec3 white = xyz_from_linear_srgb() * glm::dvec3(1);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(white[k], 1, 1e-15);
  // IEC 61966-2-1 prints four digits of the matrix; here each row is divided by white's 0.9505, 1, 1.0890.
  const glm::dmat3 m = glm::transpose(xyz_from_linear_srgb());
  const glm::dvec3 x(0.4124, 0.3576, 0.1805), y(0.2126, 0.7152, 0.0722), z(0.0193, 0.1192, 0.9505);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(m[0][k] * 0.9505, x[k], 1e-4);
    EXPECT_NEAR(m[1][k], y[k], 1e-4);
    EXPECT_NEAR(m[2][k] * 1.0890, z[k], 1e-4);
  }
  const glm::dvec3 red = lab_from_xyz(xyz_from_linear_srgb() * glm::dvec3(1, 0, 0));
  EXPECT_NEAR(red.x, 53.24, 0.01);
  EXPECT_NEAR(red.y, 80.09, 0.01);
  EXPECT_NEAR(red.z, 67.20, 0.01);
  EXPECT_NEAR(lab_from_xyz(glm::dvec3(0.18)).x, 49.50, 0.01) << "grey card";
  EXPECT_NEAR(lab_from_xyz(glm::dvec3(0.001)).x, 0.9033, 1e-4) << "CIE 15: L* = 903.3 Y where it is dark";
}

TEST(ColourSpaces, SrgbIsUndone) {
  for (int code = 0; code <= 255; ++code) {
    const double coded = code / 255.0;
    EXPECT_NEAR(srgb_from_linear(linear_from_srgb(glm::dvec3(coded))).y, coded, 1e-7) << code;
  }
  EXPECT_NEAR(linear_from_srgb(glm::dvec3(0.5)).x, 0.21404, 1e-5);
}

}  // namespace
}  // namespace gbl
