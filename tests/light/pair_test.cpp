// shaders/pair.glsl, compiled as C++ in double, gives what the reference computes from the formulas as they are published.
#include <cmath>

#include "renderer/base/random.h"
#include "renderer/truth/truth_shading.h"
#include "tests/test_support.h"

namespace gbl::test {
namespace {

struct Case {
  TruthSurface surface;
  TruthLight light;
};

using real = double;
using vec3 = glm::dvec3;
using glm::clamp, glm::dot, glm::exp2, glm::inversesqrt, glm::log2, glm::max, glm::min, glm::sqrt, glm::step;
#include "shaders/lanes.glsl"
#define PAIR_TEXT "tests/light/pair_text.inc"
#include "renderer/light/pair_variants.inc"

glm::dvec3 direction(Pcg32& random) {
  return glm::normalize(glm::dvec3(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)));
}

Case random_case(Pcg32& random, const ShadingModelOf& model) {
  Case c;
  TruthSurface& s = c.surface;
  s.position = random.in(0.5, 100) * direction(random);
  s.normal = direction(random);
  s.to_eye = -glm::normalize(s.position);
  s.f0 = {random.in(0, 1), random.in(0, 1), random.in(0, 1)};
  s.roughness = random.in(0.05, 1);
  s.exponent = model.exponent(s.roughness);
  Light& l = c.light.light;
  l.range = random.in(1, 20), l.profile_range = l.range;
  l.colour = {random.in(0, 3), random.in(0, 3), random.in(0, 3)};
  c.light.position = s.position + random.in(0, 1.1 * l.range) * direction(random);
  return c;
}

void expect_the_references_light(ShadingModel model, Attenuation attenuation, double exponent,
                                 Reflected (*by_shader)(const Case&, double)) {
  Settings s;
  s.shading.model = model, s.attenuation = attenuation, s.shading.exponent = exponent;
  const ShadingModelOf meant(s);
  Pcg32 random(11);
  int lit = 0;
  for (int k = 0; k < 2000; ++k) {
    const Case c = random_case(random, meant);
    const Reflected truth = reflected(meant, c.surface, c.light), one = by_shader(c, exponent);
    if (!truth.nothing()) ++lit;
    // Exponents up to 8192 make much of the last bits of a cosine.
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(one.diffuse[i], truth.diffuse[i], 1e-11 * (1 + truth.diffuse[i])) << k;
      EXPECT_NEAR(one.specular[i], truth.specular[i], 1e-9 * (1 + truth.specular[i])) << k;
    }
  }
  EXPECT_GT(lit, 400) << "too few of the cases are lit to say anything";
}

TEST(Pair, EveryModelIsTheReferences) {
  for (const double exponent : {-1.0, 0.0, 0.01, 16.0}) {
    expect_the_references_light(ShadingModel::lambert, Attenuation::linear, exponent,
                                lambert_linear::reflected_by_shader);
    expect_the_references_light(ShadingModel::phong, Attenuation::linear, exponent, phong_linear::reflected_by_shader);
    expect_the_references_light(ShadingModel::blinn_phong, Attenuation::linear, exponent,
                                blinn_phong_linear::reflected_by_shader);
    expect_the_references_light(ShadingModel::ggx, Attenuation::linear, exponent, ggx_linear::reflected_by_shader);
  }
}

TEST(Pair, EveryFalloffIsTheReferences) {
  using M = ShadingModel;
  using A = Attenuation;
  expect_the_references_light(M::blinn_phong, A::none, -1, blinn_phong_none::reflected_by_shader);
  expect_the_references_light(M::blinn_phong, A::quadratic, -1, blinn_phong_quadratic::reflected_by_shader);
  expect_the_references_light(M::blinn_phong, A::ramp, -1, blinn_phong_ramp::reflected_by_shader);
  expect_the_references_light(M::blinn_phong, A::inverse_linear, -1, blinn_phong_inverse_linear::reflected_by_shader);
  expect_the_references_light(M::blinn_phong, A::windowed, -1, blinn_phong_windowed::reflected_by_shader);
  expect_the_references_light(M::blinn_phong, A::gltf, -1, blinn_phong_gltf::reflected_by_shader);
}

}  // namespace
}  // namespace gbl::test
