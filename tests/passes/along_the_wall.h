#pragma once
// Along the brick wall of the room: nothing is lost of what is stored.
#include "renderer/scenes/builtin_scenes.h"
#include "tests/gl_fixture.h"

namespace gbl::test {

inline std::shared_ptr<const Scene> room() {
  static const auto scene = std::make_shared<const Scene>(build_room());
  return scene;
}

inline Settings along_the_wall() {
  Settings s = float_settings(*room());
  s.scene = "builtin:room";
  s.size = {160, 90};
  s.camera.position = {3.4, 1.9, -1.9};
  s.camera.orientation = orientation_from_yaw_pitch(62, -8);
  s.camera.fov = 50, s.camera.near = 0.05, s.camera.far = 50;
  s.lights.source = LightSource::scene;
  s.attenuation = Attenuation::windowed;
  s.height_map = HeightMap::on;
  return s;
}

}  // namespace gbl::test
