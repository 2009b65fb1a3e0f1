#pragma once
// Colours in double: the sRGB curve, CIE XYZ and CIELAB, all for the white of sRGB (D65).
#include <glm/glm.hpp>

namespace gbl {

// IEC 61966-2-1:1999; of values in 0..1.
glm::dvec3 srgb_from_linear(const glm::dvec3& linear);
glm::dvec3 linear_from_srgb(const glm::dvec3& srgb);

// XYZ here is divided by white's, so that white is (1, 1, 1): neither space below needs the illuminant again.
const glm::dmat3& xyz_from_linear_srgb();
const glm::dmat3& linear_srgb_from_xyz();

// CIE 15:2004, "Colorimetry": L* 0..100, a*, b*.
glm::dvec3 lab_from_xyz(const glm::dvec3& xyz);

}  // namespace gbl
