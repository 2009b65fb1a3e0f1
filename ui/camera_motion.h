#pragma once
// How keys and mouse move the camera: pure functions, in double like the camera itself.
#include <optional>
#include <string>
#include <vector>

#include "renderer/options/settings.h"
#include "renderer/scene/scene.h"

namespace gbl::ui {

// What the held keys ask for, each -1..1: W S forward, A D sideways, Q E down and up.
struct Motion {
  double right = 0, up = 0, forward = 0;
  double factor = 1;  // Shift 4, Ctrl 1/4
  bool any() const { return right != 0 || up != 0 || forward != 0; }
};
Motion motion_of(const std::vector<std::string>& held_keys);

// World units per second: a scene is crossed in some fifteen seconds, whatever its size.
double speed_in(const Bounds&);

Camera moved(const Camera&, const Motion&, double distance);

// A drag by that many screen pixels over a picture of that height: the picture follows the mouse's speed. Roll is
// taken out, the pitch stops short of straight up and down.
Camera turned(const Camera&, glm::dvec2 drag, double picture_height);

// Inside a light's volume: half its range from its centre, on the camera's side, looking at the centre.
Camera inside(const Camera&, const Light&);
// From one camera to the other; t = 0..1, slow at both ends.
Camera between(const Camera& from, const Camera& to, double t);

// Distance from the camera to the light's centre as a factor of the light's range: below 1 the camera is inside.
double distance_in_ranges(const Camera&, const Light&);

// The picked light of these lights; empty if there is none of that index. With lights.only the list holds that one.
std::optional<Light> picked_light(const Settings&, const std::vector<Light>&);

}  // namespace gbl::ui
