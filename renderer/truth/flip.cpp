#include "renderer/truth/flip.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "renderer/truth/colour_spaces.h"
#include "renderer/truth/flip_kernels.h"

namespace gbl {
namespace {

// Andersson et al. 2020, the names of the paper: exponents of the colour and of the feature difference, and the knee
// (share of the largest difference, value there) of the curve that leaves room for large colour differences.
constexpr double kQc = 0.7, kQf = 0.5, kPc = 0.4, kPt = 0.95;

// ---- colour ---------------------------------------------------------------------------------------------------------

// Opponent channels black-white, red-green, blue-yellow. The paper's YCxCz scales and shifts them, which a linear
// filter with weights of sum 1 does not see.
glm::dvec3 opponent_from_xyz(const glm::dvec3& xyz) { return {xyz.y, xyz.x - xyz.y, xyz.y - xyz.z}; }
glm::dvec3 xyz_from_opponent(const glm::dvec3& o) { return {o.x + o.y, o.x, o.x - o.z}; }

// CIELAB with colourfulness falling with the lightness (Hunt 1952, "Light and Dark Adaptation and the Perception of
// Color"). A filtered colour can leave what a screen shows: clamped first.
glm::dvec3 hunt_lab_from_linear(const glm::dvec3& linear) {
  const glm::dvec3 lab = lab_from_xyz(xyz_from_linear_srgb() * glm::clamp(linear, 0.0, 1.0));
  const double strength = 0.01 * lab.x;
  return {lab.x, strength * lab.y, strength * lab.z};
}

// HyAB (Abasi et al. 2020, "Distance metrics for very large color differences"), to the power of qc.
double colour_distance(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 d = a - b;
  return std::pow(std::abs(d.x) + std::hypot(d.y, d.z), kQc);
}

// No two colours of a screen are further apart than green and blue.
double largest_colour_distance() {
  static const double kLargest = colour_distance(hunt_lab_from_linear({0, 1, 0}), hunt_lab_from_linear({0, 0, 1}));
  return kLargest;
}

double colour_error(const glm::dvec3& a, const glm::dvec3& b) {
  const double distance = colour_distance(a, b), largest = largest_colour_distance(), knee = kPc * largest;
  if (distance < knee) return kPt / knee * distance;
  return kPt + (1 - kPt) * (distance - knee) / (largest - knee);
}

Plane blurred(const Plane& channel, const std::vector<SensitivityTerm>& terms) {
  Plane out(channel.size);
  for (const SensitivityTerm& t : terms) {
    const Plane term = filtered_along_y(filtered_along_x(channel, t.along), t.along);
    for (size_t i = 0; i < out.values.size(); ++i) out.values[i] += t.share * term.values[i];
  }
  return out;
}

// What the eye sees of each pixel at this distance, Hunt-adjusted CIELAB.
std::vector<glm::dvec3> seen_colours(const std::array<Plane, 3>& opponent, double pixels_per_degree) {
  const auto terms = sensitivity_kernels(pixels_per_degree);
  const std::array<Plane, 3> blur = {blurred(opponent[0], terms[0]), blurred(opponent[1], terms[1]),
                                     blurred(opponent[2], terms[2])};
  std::vector<glm::dvec3> colours(blur[0].values.size());
  for (size_t i = 0; i < colours.size(); ++i) {
    const glm::dvec3 o(blur[0].values[i], blur[1].values[i], blur[2].values[i]);
    colours[i] = hunt_lab_from_linear(linear_srgb_from_xyz() * xyz_from_opponent(o));
  }
  return colours;
}

// ---- features -------------------------------------------------------------------------------------------------------

// How strongly the luminance changes across x and y together.
std::vector<double> strength(const Plane& smooth_in_x, const Plane& smooth_in_y, const Kernel& across) {
  const Plane in_x = filtered_along_x(smooth_in_y, across), in_y = filtered_along_y(smooth_in_x, across);
  std::vector<double> out(in_x.values.size());
  for (size_t i = 0; i < out.size(); ++i) out[i] = std::hypot(in_x.values[i], in_y.values[i]);
  return out;
}

struct Features {
  std::vector<double> edge, point;
};

Features features_of(const Plane& luminance, double pixels_per_degree) {
  const FeatureKernels k = feature_kernels(pixels_per_degree);
  const Plane smooth_in_x = filtered_along_x(luminance, k.smooth), smooth_in_y = filtered_along_y(luminance, k.smooth);
  return {strength(smooth_in_x, smooth_in_y, k.edge), strength(smooth_in_x, smooth_in_y, k.point)};
}

double feature_error(const Features& a, const Features& b, size_t i) {
  const double difference = std::max(std::abs(a.edge[i] - b.edge[i]), std::abs(a.point[i] - b.point[i]));
  return std::pow(std::min(difference / std::sqrt(2.0), 1.0), kQf);  // two axes of at most 1 each: sqrt(2) at most
}

// ---- both -----------------------------------------------------------------------------------------------------------

struct Seen {
  std::vector<glm::dvec3> colours;
  Features features;
};

Seen seen(glm::ivec2 size, const std::vector<glm::dvec3>& coded, double pixels_per_degree) {
  std::array<Plane, 3> opponent = {Plane(size), Plane(size), Plane(size)};
  for (size_t i = 0; i < coded.size(); ++i) {
    const glm::dvec3 o = opponent_from_xyz(xyz_from_linear_srgb() * linear_from_srgb(coded[i]));
    for (int k = 0; k < 3; ++k) opponent[static_cast<size_t>(k)].values[i] = o[k];
  }
  return {seen_colours(opponent, pixels_per_degree), features_of(opponent[0], pixels_per_degree)};
}

}  // namespace

std::vector<double> flip(glm::ivec2 size, const std::vector<glm::dvec3>& reference, const std::vector<glm::dvec3>& test,
                         double pixels_per_degree) {
  assert(reference.size() == static_cast<size_t>(size.x) * static_cast<size_t>(size.y));
  assert(test.size() == reference.size() && pixels_per_degree > 0);
  if (reference.empty()) return {};
  const Seen a = seen(size, reference, pixels_per_degree), b = seen(size, test, pixels_per_degree);
  std::vector<double> map(reference.size());
  for (size_t i = 0; i < map.size(); ++i) {
    const double of_features = feature_error(a.features, b.features, i);
    map[i] = std::min(std::pow(colour_error(a.colours[i], b.colours[i]), 1 - of_features), 1.0);
  }
  return map;
}

}  // namespace gbl
