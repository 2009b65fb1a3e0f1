#pragma once
// The sRGB curve (IEC 61966-2-1:1999) of one channel on the CPU, 0..1, in the arithmetic of its argument. The shaders'
// own stands in shaders/colour.glsl.
#include <cmath>

namespace gbl {

template <class Real>
Real srgb_from_linear(Real x) {
  return x <= Real(0.0031308) ? Real(12.92) * x : Real(1.055) * std::pow(x, 1 / Real(2.4)) - Real(0.055);
}

template <class Real>
Real linear_from_srgb(Real x) {
  return x <= Real(0.04045) ? x / Real(12.92) : std::pow((x + Real(0.055)) / Real(1.055), Real(2.4));
}

}  // namespace gbl
