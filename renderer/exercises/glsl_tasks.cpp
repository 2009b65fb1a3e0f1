#include "renderer/exercises/glsl_tasks.h"

#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include "renderer/base/error.h"

namespace gbl {
namespace {

// ---- inputs --------------------------------------------------------------------------------------------------------

// Evenly over the sphere (Fibonacci's spiral), then axes and diagonals, where folds and poles lie.
std::vector<glm::dvec3> directions() {
  constexpr int kCount = 1000;
  const double turn = glm::pi<double>() * (3 - std::sqrt(5.0));
  std::vector<glm::dvec3> all;
  for (int i = 0; i < kCount; ++i) {
    const double z = 1 - (2 * i + 1.0) / kCount, r = std::sqrt(1 - z * z);
    all.emplace_back(r * std::cos(turn * i), r * std::sin(turn * i), z);
  }
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) all.push_back(glm::normalize(glm::dvec3(x, y, z)));
  return all;
}

std::vector<GlslInput> unit_directions() {
  std::vector<GlslInput> out;
  for (const glm::dvec3& d : directions()) out.push_back({glm::vec4(d, 0)});
  return out;
}

double sign_not_zero(double x) { return x < 0 ? -1 : 1; }

// Meyer et al. 2010, "On floating-point normal vectors": the lower half folded over the upper one's edges.
std::vector<GlslInput> octahedron_points() {
  std::vector<GlslInput> out;
  for (const glm::dvec3& d : directions()) {
    const glm::dvec3 p = d / (std::abs(d.x) + std::abs(d.y) + std::abs(d.z));
    const glm::dvec2 folded((1 - std::abs(p.y)) * sign_not_zero(p.x), (1 - std::abs(p.x)) * sign_not_zero(p.y));
    const glm::dvec2 at = p.z < 0 ? folded : glm::dvec2(p);
    out.push_back({{at.x, at.y, 0, 0}});
  }
  return out;
}

struct Planes {
  double near, far;
};
constexpr Planes kPlanes[] = {{0.5, 200}, {1, 1000}, {0.1, 10}};
constexpr int kSteps = 12;

// Window depth 0..1 of a perspective, as OpenGL writes it.
double window_depth(Planes p, double range) { return p.far * (range - p.near) / (range * (p.far - p.near)); }

// a: x and y from -1 to 1, window depth. b: tangents of half the field of view across and up, near, far.
std::vector<GlslInput> pixels_with_depth() {
  std::vector<GlslInput> out;
  for (const Planes& p : kPlanes)
    for (int i = 0; i <= kSteps; ++i)
      for (int j = 0; j <= kSteps; ++j) {
        const double x = 2.0 * i / kSteps - 1, y = 2.0 * j / kSteps - 1;
        const double share = ((i * 5 + j * 7) % (kSteps + 1)) / double(kSteps);
        const double range = p.near * std::pow(0.5 * p.far / p.near, share);  // beyond, float has few depths left
        out.push_back({{x, y, window_depth(p, range), 0}, {0.7364, 0.4142, p.near, p.far}});
      }
  return out;
}

// a: window depth, near, far.
std::vector<GlslInput> depths() {
  std::vector<GlslInput> out;
  constexpr int kDepths = 64;
  for (const Planes& p : kPlanes)
    for (int i = 0; i <= kDepths; ++i) {
      const double range = p.near + (p.far - p.near) * i / kDepths;
      out.push_back({{window_depth(p, range), p.near, p.far, 0}});
    }
  return out;
}

// a: radius, the brightest channel, the threshold.
std::vector<GlslInput> lamps() {
  std::vector<GlslInput> out;
  for (const double radius : {0.5, 3.0, 40.0})
    for (const double brightest : {0.5, 1.0, 1.5, 20.0})
      for (const double threshold : {1.0 / 256, 5.0 / 256, 0.05, 0.1})
        out.push_back({{radius, brightest, threshold, 0}});
  return out;
}

// ---- references ----------------------------------------------------------------------------------------------------

glm::dvec4 same(const glm::dvec4& a, const glm::dvec4& /*b*/) { return a; }

glm::dvec4 octahedral_direction(const glm::dvec4& a, const glm::dvec4& /*b*/) {
  glm::dvec3 v(a.x, a.y, 1 - std::abs(a.x) - std::abs(a.y));
  if (v.z < 0) v = {(1 - std::abs(a.y)) * sign_not_zero(a.x), (1 - std::abs(a.x)) * sign_not_zero(a.y), v.z};
  return {glm::normalize(v), 0};
}

// Along the view axis; of a perspective.
double range_of(double depth, double near, double far) { return near * far / (far - depth * (far - near)); }

glm::dvec4 view_position(const glm::dvec4& a, const glm::dvec4& b) {
  const double range = range_of(a.z, b.z, b.w);
  return {a.x * b.x * range, a.y * b.y * range, -range, 1};
}

glm::dvec4 linear_depth(const glm::dvec4& a, const glm::dvec4& /*b*/) {
  return {(range_of(a.x, a.y, a.z) - a.y) / (a.z - a.y), 0, 0, 0};
}

// Where brightest / (0.2 + 0.4 x + 0.4 x^2) has fallen to the threshold, x in radii.
glm::dvec4 ramp_range(const glm::dvec4& a, const glm::dvec4& /*b*/) {
  const double c = 0.2 - a.y / a.z;
  return {a.x * (-0.4 + std::sqrt(0.16 - 1.6 * c)) / 0.8, 0, 0, 0};
}

// ---- errors --------------------------------------------------------------------------------------------------------

double angle_deg(const glm::dvec4& got, const glm::dvec4& meant) {
  const glm::dvec3 g(got), m(meant);
  if (g == glm::dvec3(0)) return 180;
  const double length_off = std::abs(glm::length(g) - glm::length(m));  // of a direction that is not of length 1
  return glm::degrees(std::atan2(glm::length(glm::cross(g, m)), glm::dot(g, m)) + length_off);
}
double absolute(const glm::dvec4& got, const glm::dvec4& meant) { return glm::length(got - meant); }
double relative(const glm::dvec4& got, const glm::dvec4& meant) {
  return absolute(got, meant) / std::max(glm::length(meant), 1e-12);
}

template <class Function>
struct Named {
  const char* id;
  Function* function;
  const char* unit = "";
};
constexpr Named<std::vector<GlslInput>()> kInputs[] = {{"unit-directions", unit_directions},
                                                       {"octahedron-points", octahedron_points},
                                                       {"pixels-with-depth", pixels_with_depth},
                                                       {"depths", depths},
                                                       {"lamps", lamps}};
constexpr Named<glm::dvec4(const glm::dvec4&, const glm::dvec4&)> kReferences[] = {
    {"input", same},
    {"octahedral-direction", octahedral_direction},
    {"view-position", view_position},
    {"linear-depth", linear_depth},
    {"ramp-range", ramp_range}};
constexpr Named<double(const glm::dvec4&, const glm::dvec4&)> kErrors[] = {
    {"angle", angle_deg, "degrees"}, {"absolute", absolute}, {"relative", relative, "of the value"}};

template <class Row, size_t kCount>
const Row& named(const Row (&table)[kCount], std::string_view id, const char* what) {
  std::vector<std::string_view> known;
  for (const Row& r : table) {
    if (id == r.id) return r;
    known.emplace_back(r.id);
  }
  throw Error(ExitCode::bad_input, what, fmt::format("'{}' is unknown", id), suggest(id, known));
}

bool finite(const glm::vec4& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

}  // namespace

void require_known(const GlslCheck& c) {
  named(kInputs, c.inputs, "inputs"), named(kReferences, c.expected, "expected"), named(kErrors, c.error, "error");
}

std::vector<GlslInput> inputs_of(const GlslCheck& c) { return named(kInputs, c.inputs, "inputs").function(); }

GlslError error_of(const GlslCheck& c, std::span<const GlslInput> inputs, std::span<const glm::vec4> results) {
  const auto& expected = named(kReferences, c.expected, "expected");
  const auto& error = named(kErrors, c.error, "error");
  GlslError out{-1, {}};
  for (size_t i = 0; i < inputs.size(); ++i) {
    const glm::dvec4 meant = expected.function(glm::dvec4(inputs[i].a), glm::dvec4(inputs[i].b));
    const double e = finite(results[i]) ? error.function(glm::dvec4(results[i]), meant) : INFINITY;
    if (e > out.most) out = {e, inputs[i]};
  }
  return out;
}

const char* unit_of_error(const GlslCheck& c) { return named(kErrors, c.error, "error").unit; }

}  // namespace gbl
