#pragma once
// What the advisor may choose: a set-up that loses nothing, and the values of each axis that may stand in the place of its own.
#include <functional>
#include <vector>

#include "renderer/frame/validate.h"
#include "renderer/options/options.h"

namespace gbl {

using Patch = std::vector<Assignment>;
using Values = std::vector<Patch>;  // of one axis, each as a patch over the lossless set-up

void apply_values(Settings&, const Patch&);

// Everything that a G-buffer could lose is kept, everything that is approximate is off. Depth decides which surface is
// seen even where positions are stored apart: the finest there is.
Settings lossless(const Settings& truth, FeatureSet);

// The sound values of one axis that this device has.
template <class E>
void for_sound_rows(const DeviceLimits& limits, const std::function<void(const ValueRow&)>& each) {
  for (const ValueRow& r : rows<E>())
    if (r.sound() && limits.features.has(r.needs)) each(r);
}

// Of layouts, normals, positions, sums of light: the sound ones that this device has.
std::vector<Values> axis_values(const DeviceLimits&);

}  // namespace gbl
