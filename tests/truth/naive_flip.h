#pragma once
// FLIP once more, as Andersson et al. 2020 write it: whole squares of weights, nothing separated, one pixel at a time.
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/truth/colour_spaces.h"

namespace gbl::test {

using Pixels = std::vector<glm::dvec3>;

inline size_t count(glm::ivec2 size) { return static_cast<size_t>(size.x) * static_cast<size_t>(size.y); }
inline size_t index(glm::ivec2 size, int x, int y) {
  return static_cast<size_t>(y) * static_cast<size_t>(size.x) + static_cast<size_t>(x);
}
struct Square {
  int radius;
  std::vector<double> weights;
};

template <class F>
inline Square square_of(int radius, F weight) {
  Square s{radius, {}};
  for (int y = -radius; y <= radius; ++y)
    for (int x = -radius; x <= radius; ++x) s.weights.push_back(weight(double(x), double(y)));
  double positive = 0, negative = 0;
  for (const double w : s.weights) (w > 0 ? positive : negative) += std::abs(w);
  for (double& w : s.weights) w /= w > 0 ? positive : negative;
  return s;
}

inline double filtered(const std::vector<double>& picture, glm::ivec2 size, glm::ivec2 at, const Square& s) {
  double sum = 0;
  size_t tap = 0;
  for (int y = -s.radius; y <= s.radius; ++y)
    for (int x = -s.radius; x <= s.radius; ++x) {
      const glm::ivec2 p = glm::clamp(at + glm::ivec2(x, y), glm::ivec2(0), size - 1);
      sum += s.weights[tap++] * picture[index(size, p.x, p.y)];
    }
  return sum;
}

inline glm::dvec3 ycxcz(const glm::dvec3& xyz) {
  return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}
inline glm::dvec3 xyz_of(const glm::dvec3& o) {
  const double y = (o.x + 16) / 116;
  return {y + o.y / 500, y, y - o.z / 200};
}

inline constexpr double kPi = 3.14159265358979323846;

inline Square sensitivity(double ppd, double a1, double b1, double a2, double b2) {
  const int radius = int(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * ppd));
  return square_of(radius, [&](double x, double y) {
    const double r2 = (x * x + y * y) / (ppd * ppd);
    const auto term = [&](double a, double b) { return a * std::sqrt(kPi / b) * std::exp(-kPi * kPi * r2 / b); };
    return term(a1, b1) + term(a2, b2);
  });
}

inline double hyab(const glm::dvec3& a, const glm::dvec3& b) {
  return std::abs(a.x - b.x) + std::sqrt((a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}
inline glm::dvec3 hunt(const glm::dvec3& lab) { return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z}; }

inline double redistributed(double distance, const glm::dvec3& green, const glm::dvec3& blue) {
  const double e = std::pow(distance, 0.7), cmax = std::pow(hyab(hunt(green), hunt(blue)), 0.7);
  return e < 0.4 * cmax ? 0.95 * e / (0.4 * cmax) : 0.95 + 0.05 * (e - 0.4 * cmax) / (0.6 * cmax);
}

// Published CIELAB values of the two primaries under D65: an answer that takes nothing from our colour spaces.
inline double by_published_colours(double distance) {
  return redistributed(distance, {87.7347, -86.1827, 83.1793}, {32.2970, 79.1875, -107.8602});
}

// The weights of the edge and of the point detector along x; those along y are the same with x and y exchanged.
struct Detectors {
  explicit Detectors(double ppd) : sd(0.5 * 0.082 * ppd), radius(int(std::ceil(3 * sd))) {}
  double gaussian(double x, double y) const { return std::exp(-(x * x + y * y) / (2 * sd * sd)); }
  double edge(double x, double y) const { return -x * gaussian(x, y); }
  double point(double x, double y) const { return (x * x / (sd * sd) - 1) * gaussian(x, y); }

  double sd;
  int radius;
  Square edge_x = square_of(radius, [this](double x, double y) { return edge(x, y); });
  Square edge_y = square_of(radius, [this](double x, double y) { return edge(y, x); });
  Square point_x = square_of(radius, [this](double x, double y) { return point(x, y); });
  Square point_y = square_of(radius, [this](double x, double y) { return point(y, x); });
};

struct Naive {
  Naive(glm::ivec2 s, const Pixels& coded, double ppd) : size(s), detectors(ppd) {
    sensitivities = {sensitivity(ppd, 1, 0.0047, 0, 1e-5), sensitivity(ppd, 1, 0.0053, 0, 1e-5),
                     sensitivity(ppd, 34.1, 0.04, 13.5, 0.025)};
    for (const glm::dvec3& c : coded) {
      const glm::dvec3 o = ycxcz(xyz_from_linear_srgb() * linear_from_srgb(c));
      for (int k = 0; k < 3; ++k) channels[k].push_back(o[k]);
      luminance.push_back((o.x + 16) / 116);
    }
  }
  glm::dvec3 colour(glm::ivec2 at) const {
    glm::dvec3 o;
    for (int k = 0; k < 3; ++k) o[k] = filtered(channels[k], size, at, sensitivities[static_cast<size_t>(k)]);
    const glm::dvec3 linear = glm::clamp(glm::inverse(xyz_from_linear_srgb()) * xyz_of(o), 0.0, 1.0);
    return hunt(lab_from_xyz(xyz_from_linear_srgb() * linear));
  }
  glm::dvec2 features(glm::ivec2 at) const {  // edge, point
    const auto f = [&](const Square& s) { return filtered(luminance, size, at, s); };
    return {std::hypot(f(detectors.edge_x), f(detectors.edge_y)),
            std::hypot(f(detectors.point_x), f(detectors.point_y))};
  }

  glm::ivec2 size;
  Detectors detectors;
  std::vector<Square> sensitivities;
  std::vector<double> channels[3], luminance;
};

inline double naive_flip(const Naive& a, const Naive& b, glm::ivec2 at) {
  const glm::dvec2 d = glm::abs(a.features(at) - b.features(at));
  const glm::dmat3& xyz = xyz_from_linear_srgb();
  const double of_colour = redistributed(hyab(a.colour(at), b.colour(at)), lab_from_xyz(xyz[1]), lab_from_xyz(xyz[2]));
  return std::pow(of_colour, 1 - std::pow(std::max(d.x, d.y) / std::sqrt(2.0), 0.5));
}

}  // namespace gbl::test
