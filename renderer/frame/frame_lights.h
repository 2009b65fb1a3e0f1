#pragma once
// The lights of a frame, as a pure function of settings and scene.
#include <vector>

#include "renderer/options/settings.h"
#include "renderer/scene/scene.h"

namespace gbl {

// What Settings ask for: source, count, seed, time, range scale, `only` and `first`.
std::vector<Light> lights_of(const Settings&, const Scene&);

// Those that `only` chooses from.
std::vector<Light> all_lights_of(const Settings&, const Scene&);

}  // namespace gbl
