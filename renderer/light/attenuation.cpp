#include "renderer/light/attenuation.h"

#include <algorithm>
#include <cmath>

namespace gbl {

double attenuation_at(Attenuation a, double d, double r) {
  const double x = d / r;
  switch (a) {
    case Attenuation::none: return 1;
    case Attenuation::linear: return 1 - std::clamp(x, 0.0, 1.0);
    case Attenuation::quadratic: return 1 / (1 + 0.7 * d + 1.8 * d * d);
    case Attenuation::ramp: return 1 / std::max(1.0, 0.2 + 0.4 * (4 * x) + 0.4 * (4 * x) * (4 * x));
    case Attenuation::inverse_linear: return 1 / (1 + 9 * x);
    case Attenuation::windowed: {
      const double window = std::clamp(1 - x * x * x * x, 0.0, 1.0);
      return window * window / std::max(d * d, 1e-4);
    }
    case Attenuation::gltf: return std::clamp(1 - x * x * x * x, 0.0, 1.0) / std::max(d * d, 1e-8);
  }
  return 0;
}

double range_at_threshold(Attenuation a, double strength, double r, double threshold) {
  const auto faint = [&](double d) { return strength * attenuation_at(a, d, r) <= threshold; };
  if (!(r > 0) || faint(0)) return 0;  // too dim to reach the threshold anywhere: no light (`radius-nan-dim-light`)
  double inside = 0, outside = r;
  while (!faint(outside)) {
    inside = outside;
    outside *= 2;
    if (outside > 1e6 * r) return r;
  }
  for (int i = 0; i < 200 && inside < outside; ++i) {
    const double middle = (inside + outside) / 2;
    (faint(middle) ? outside : inside) = middle;
  }
  return outside;
}

double range_by_shortcut(double strength, double r, double threshold) {
  return r / 4 * std::sqrt(std::max(0.0, strength / threshold - 0.2));
}

}  // namespace gbl
