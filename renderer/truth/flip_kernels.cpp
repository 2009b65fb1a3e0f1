#include "renderer/truth/flip_kernels.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace gbl {
namespace {

constexpr double kPi = 3.14159265358979323846;

// A channel's sensitivity over the distance r in degrees: sum of a sqrt(pi / b) exp(-pi^2 r^2 / b). Values: Andersson
// et al. 2020, section 4.1; a = 0 is no term.
struct Gaussian {
  double a, b;
};
constexpr Gaussian kSensitivity[3][2] = {
    {{1, 0.0047}, {0, 1e-5}}, {{1, 0.0053}, {0, 1e-5}}, {{34.1, 0.04}, {13.5, 0.025}}};
constexpr double kWidestB = 0.04;  // the largest b of them all: one radius serves every channel

// The human edge detector: 0.082 degrees from its peak to its trough, two standard deviations (the same, section 4.2).
constexpr double kPeakToTroughDeg = 0.082;

template <class F>
Kernel kernel_of(int radius, F weight) {
  Kernel k;
  for (int x = -radius; x <= radius; ++x) k.weights.push_back(weight(static_cast<double>(x)));
  return k;
}

double sum(const Kernel& k) {
  double s = 0;
  for (const double w : k.weights) s += w;
  return s;
}

// Positive and negative weights each to a sum of one. Both parts of a separable kernel can be scaled on their own: the
// sign of a two-dimensional weight is that of this axis' part, the other axis' being positive.
Kernel balanced(Kernel k) {
  double positive = 0, negative = 0;
  for (const double w : k.weights) (w > 0 ? positive : negative) += std::abs(w);
  for (double& w : k.weights) w /= w > 0 ? positive : std::max(negative, 1e-300);  // a Gaussian has no negative ones
  return k;
}

// exp(-(x^2 + y^2)) is exp(-x^2) exp(-y^2): the weights of the whole square sum to the square of one axis' sum.
std::vector<SensitivityTerm> terms_of(std::span<const Gaussian> gaussians, int radius, double pixels_per_degree) {
  std::vector<SensitivityTerm> terms;
  double whole = 0;
  for (const Gaussian& g : gaussians) {
    if (g.a == 0) continue;
    const Kernel along = kernel_of(radius, [&](double x) {
      const double r_deg = x / pixels_per_degree;
      return std::exp(-kPi * kPi * r_deg * r_deg / g.b);
    });
    const double square = g.a * std::sqrt(kPi / g.b) * sum(along) * sum(along);
    terms.push_back({square, balanced(along)});
    whole += square;
  }
  for (SensitivityTerm& t : terms) t.share /= whole;
  return terms;
}

}  // namespace

std::array<std::vector<SensitivityTerm>, 3> sensitivity_kernels(double pixels_per_degree) {
  const double deviation_deg = std::sqrt(kWidestB / (2 * kPi * kPi));
  const int radius = static_cast<int>(std::ceil(3 * deviation_deg * pixels_per_degree));
  std::array<std::vector<SensitivityTerm>, 3> channels;
  for (size_t k = 0; k < 3; ++k) channels[k] = terms_of(kSensitivity[k], radius, pixels_per_degree);
  return channels;
}

FeatureKernels feature_kernels(double pixels_per_degree) {
  const double deviation = 0.5 * kPeakToTroughDeg * pixels_per_degree;  // pixels
  const int radius = static_cast<int>(std::ceil(3 * deviation));
  const auto gaussian = [&](double x) { return std::exp(-x * x / (2 * deviation * deviation)); };
  return {balanced(kernel_of(radius, gaussian)),
          balanced(kernel_of(radius, [&](double x) { return -x * gaussian(x); })),
          balanced(kernel_of(radius, [&](double x) { return (x * x / (deviation * deviation) - 1) * gaussian(x); }))};
}

}  // namespace gbl
