#include "renderer/pitfalls/mistakes.h"

#include <fmt/format.h>

#include "renderer/base/error.h"

namespace gbl {
namespace {

// clang-format off
constexpr Mistake kMistakes[] = {
  {"tbn-precedence", "normal map: turned, then expanded", "TBN * texel * 2 - 1 for TBN * (texel * 2 - 1): lighting tilts with the compass; ground whose frame runs along +X and +Z hides it",
   "nclgl tutorial 15, bufferFragment.glsl lines 19-20", MistakeIn::surface},
  {"interpolated-not-normalised", "interpolated normals stored as they are", "shorter than 1 between vertices: edges' middles darker, highlights gone",
   "engine blog, part 31: Nv is stored as it arrives", MistakeIn::surface},
  {"nonuniform-scale-normal", "normals turned like positions", "a squashed model is lit as if it were not: the inverse transpose is missing",
   "tutorial 08-2, shader_deferred_geometry.vs", MistakeIn::surface},
  {"blend-on-in-fill", "blending left on while the G-buffer is filled", "alpha is data there, not coverage: what is stored is mixed with what was cleared",
   "nclgl tutorial 15, renderer.cpp lines 103 and 240", MistakeIn::pass},
  {"decode-not-normalised", "decoded normals used as they are", "8-bit codes are .993 to 1.007 long, and a power of 256 makes .19 to 5.4 of that",
   "engine blog, geomainpass.fs", MistakeIn::shading},
  {"specular-ungated", "highlights without N.L", "faces that are turned away from a light still glitter, and light leaks under floors",
   "nclgl tutorial 15, pointlightfragment.glsl lines 38-42; tutorial 08-2, ProcessPointLights", MistakeIn::shading},
  {"volume-without-distance-test", "no distance test under a volume", "a sphere's silhouette is shaded, not the sphere: discs of light on far walls behind it",
   "de Vries 2014, LearnOpenGL, Deferred Shading: light volumes", MistakeIn::shading},
  {"range-shortcut", "a light's range by a shortcut", "the linear term is left out: the light ends at 65 to 73 % of its range, brighter than meant",
   "engine blog, part 30: range = radius * sqrt(maxIllum / threshold - 0.2)", MistakeIn::pass},
  {"forward-without-depth", "forward draws without the scene's depth", "light markers and glass shine through walls",
   "de Vries 2014, LearnOpenGL, Deferred Shading: before the depth blit", MistakeIn::pass},
};
// clang-format on

}  // namespace

std::span<const Mistake> mistakes() { return kMistakes; }

const Mistake& mistake(std::string_view id) {
  std::vector<std::string_view> known;
  for (const Mistake& m : kMistakes) {
    if (m.id == id) return m;
    known.push_back(m.id);
  }
  throw Error(ExitCode::bad_input, "mistakes", fmt::format("unknown mistake '{}'", id), suggest(id, known));
}

}  // namespace gbl
