#include "renderer/truth/colour_spaces.h"

#include <cmath>

#include "renderer/picture/srgb.h"

namespace gbl {
namespace {

// IEC 61966-2-1:1999: chromaticities (x, y) of the three primaries and of white.
constexpr glm::dvec2 kRed{0.64, 0.33}, kGreen{0.30, 0.60}, kBlue{0.15, 0.06}, kWhite{0.3127, 0.3290};

glm::dvec3 with_z(const glm::dvec2& xy) { return {xy, 1 - xy.x - xy.y}; }

// The primaries' amounts are such that all three at 1 make white with Y = 1.
glm::dmat3 derived_xyz_from_linear_srgb() {
  const glm::dmat3 primaries(with_z(kRed), with_z(kGreen), with_z(kBlue));
  const glm::dvec3 white = with_z(kWhite) / kWhite.y, amounts = glm::inverse(primaries) * white;
  glm::dmat3 m;
  for (int k = 0; k < 3; ++k) m[k] = primaries[k] * amounts[k] / white;
  return m;
}

// A cube root with a straight piece below (6/29)^3, where the root would be too steep.
double lightness_curve(double x) {
  constexpr double kDelta = 6.0 / 29;
  return x > kDelta * kDelta * kDelta ? std::cbrt(x) : x / (3 * kDelta * kDelta) + 4.0 / 29;
}

}  // namespace

glm::dvec3 srgb_from_linear(const glm::dvec3& linear) {
  return {srgb_from_linear(linear.x), srgb_from_linear(linear.y), srgb_from_linear(linear.z)};
}
glm::dvec3 linear_from_srgb(const glm::dvec3& srgb) {
  return {linear_from_srgb(srgb.x), linear_from_srgb(srgb.y), linear_from_srgb(srgb.z)};
}

const glm::dmat3& xyz_from_linear_srgb() {
  static const glm::dmat3 kMatrix = derived_xyz_from_linear_srgb();
  return kMatrix;
}

const glm::dmat3& linear_srgb_from_xyz() {
  static const glm::dmat3 kMatrix = glm::inverse(xyz_from_linear_srgb());
  return kMatrix;
}

glm::dvec3 lab_from_xyz(const glm::dvec3& xyz) {
  const double x = lightness_curve(xyz.x), y = lightness_curve(xyz.y), z = lightness_curve(xyz.z);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

}  // namespace gbl
