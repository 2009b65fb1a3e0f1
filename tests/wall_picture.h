#pragma once
// A picture with known answers for the tests of the measures.
#include <glm/glm.hpp>
#include <limits>

#include "renderer/truth/measure.h"

namespace gbl::test {

inline constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
inline constexpr Display kLinear{.exposure = 1, .colour = Colour::as_tutorial};

// A picture and what was drawn of it; at first they agree.
struct Pair {
  Truth truth;
  Drawn drawn;
};

// Every pixel: a wall seen head-on, ambient 0.25, light 0.25.
inline Pair wall(glm::ivec2 size) {
  Pair p;
  Truth& t = p.truth;
  t.size = size;
  const size_t n = t.pixels();
  t.present.assign(n, 1), t.lit.assign(n, glm::dvec3(0.5)), t.diffuse.assign(n, glm::dvec3(0.5));
  t.specular.assign(n, glm::dvec3(0)), t.albedo.assign(n, glm::dvec3(0.5)), t.roughness.assign(n, 0.5);
  t.unshadowed.assign(n, glm::dvec3(0.25));
  t.normal.assign(n, glm::dvec3(0, 0, 1)), t.position.assign(n, glm::dvec3(0, 0, -4));
  p.drawn.lit.assign(n, glm::vec3(0.5f)), p.drawn.unlit.assign(n, glm::vec3(0.25f));
  p.drawn.shown = p.drawn.lit;
  p.drawn.normal.assign(n, glm::vec3(0, 0, 1)), p.drawn.position.assign(n, glm::vec3(0, 0, -4));
  p.drawn.seen.assign(n, {1, 0});
  return p;
}

inline Errors measured(const Pair& p, const Display& display = kLinear) { return measure(p.truth, p.drawn, display); }

}  // namespace gbl::test
