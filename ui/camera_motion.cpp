#include "ui/camera_motion.h"

#include <algorithm>
#include <cmath>

namespace gbl::ui {
namespace {
constexpr double kSteepestPitch = 89;  // degrees: beyond it left and right would swap
constexpr double kSecondsAcrossScene = 15;
}  // namespace

Motion motion_of(const std::vector<std::string>& held) {
  const auto down = [&](const char* key) { return std::find(held.begin(), held.end(), key) != held.end() ? 1.0 : 0.0; };
  Motion m;
  m.right = down("d") - down("a");
  m.up = down("e") - down("q");
  m.forward = down("w") - down("s");
  m.factor = (down("Shift") != 0 ? 4 : 1) * (down("Ctrl") != 0 ? 0.25 : 1);
  return m;
}

double speed_in(const Bounds& bounds) { return std::max(1e-3, glm::length(bounds.extent())) / kSecondsAcrossScene; }

Camera moved(const Camera& camera, const Motion& m, double distance) {
  const glm::dvec3 way = camera.forward() * m.forward + camera.right() * m.right + glm::dvec3(0, m.up, 0);
  if (glm::length(way) < 1e-9) return camera;
  Camera c = camera;
  c.position += glm::normalize(way) * distance * m.factor;
  return c;
}

Camera turned(const Camera& camera, glm::dvec2 drag, double picture_height) {
  const double degrees_per_pixel = (camera.orthographic() ? 45 : camera.fov) / std::max(1.0, picture_height);
  const glm::dvec2 yaw_pitch = yaw_pitch_of(camera.orientation);
  Camera c = camera;
  c.orientation =
      orientation_from_yaw_pitch(yaw_pitch.x - drag.x * degrees_per_pixel,
                                 std::clamp(yaw_pitch.y - drag.y * degrees_per_pixel, -kSteepestPitch, kSteepestPitch));
  return c;
}

Camera inside(const Camera& camera, const Light& light) {
  const glm::dvec3 to_camera = camera.position - light.position;
  const double distance = glm::length(to_camera);
  const glm::dvec3 side = distance > 1e-9 ? to_camera / distance : -camera.forward();
  Camera c = camera;
  c.position = light.position + side * (light.range / 2);
  const double pitch = glm::degrees(std::asin(std::clamp(-side.y, -1.0, 1.0)));
  const double yaw =
      std::abs(side.y) < 1 - 1e-9 ? glm::degrees(std::atan2(side.x, side.z)) : yaw_pitch_of(camera.orientation).x;
  c.orientation = orientation_from_yaw_pitch(yaw, std::clamp(pitch, -kSteepestPitch, kSteepestPitch));
  return c;
}

Camera between(const Camera& from, const Camera& to, double t) {
  if (t >= 1) return to;
  const double k = t * t * (3 - 2 * t);
  Camera c = to;
  c.position = glm::mix(from.position, to.position, k);
  c.orientation = glm::slerp(from.orientation, to.orientation, k);
  return c;
}

double distance_in_ranges(const Camera& camera, const Light& light) {
  return glm::length(camera.position - light.position) / light.range;
}

std::optional<Light> picked_light(const Settings& s, const std::vector<Light>& lights) {
  const int index = s.lights.only >= 0 && s.lights.only == s.view.pick ? 0 : s.view.pick;
  if (index < 0 || index >= static_cast<int>(lights.size())) return {};
  return lights[index];
}

}  // namespace gbl::ui
