#pragma once
// The arithmetic of shaders/pair.glsl as a C++ compiler makes it, eight pixels side by side: what a pair would cost if nothing
// but that were to be done. It needs AVX2.
#include <optional>
#include <vector>

#include "renderer/options/settings.h"

namespace gbl {

// Of `lights` lights on blocks of eight pixels each, on all processors; the best of a few runs. None: this processor or
// build has no AVX2, or there is no such variant (renderer/light/pair_variants.inc).
std::optional<double> arithmetic_ns_per_pair(ShadingModel, Attenuation, int lights, int blocks);

}  // namespace gbl
