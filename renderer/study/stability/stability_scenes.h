#pragma once
// Small scenes that the sweeps make, and the settings in which nothing but the swept choice is lost.
#include <string>
#include <vector>

#include "renderer/study/stability/stability.h"

namespace gbl {

// Full-screen lighting, everything in float32, Lambert, black where no light is; the scene's own lights.
Settings exact_settings(const std::string& scene_name, glm::ivec2 size);

// A light of white colour.
Light lamp(const glm::dvec3& position, double range, double intensity = 1);

// A square from -1 to 1 in x and y that faces +Z, shown through `world_from_wall`; white, Lambert.
SweepSetup wall_setup(const std::string& name, glm::ivec2 size, const glm::dmat4& world_from_wall,
                      std::vector<Light> lights);

// Turned towards +Z, `half` units to each side.
glm::dmat4 wall_at(const glm::dvec3& middle, double half);

// A square before the camera, `range` units away along the view axis and larger than the picture. It is tilted by a few
// degrees, so that its depths are many and not one.
glm::dmat4 wall_before(const Camera&, double range);

}  // namespace gbl
