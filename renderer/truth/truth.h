#pragma once
// What a frame is judged by, and what is judged: plain pictures, rows top to bottom, no GL.
#include <compare>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace gbl {

// The surface that a pixel shows: an object of the scene, from 1, and a triangle of its mesh, from 0.
struct SeenSurface {
  int object = 0, triangle = 0;  // object 0: the background; below: not known
  auto operator<=>(const SeenSurface&) const = default;
};

// A surface that the reference sees so near to a pixel's centre that a rasteriser may show it there (ties.h).
struct Rival {
  size_t pixel = 0;
  SeenSurface surface;
  auto operator<=>(const Rival&) const = default;
};

// What the reference found, in double. Every list has size.x * size.y members; where `present` is 0 no surface is
// seen, `lit` is the background's radiance and the rest means nothing.
struct Truth {
  glm::ivec2 size{0};
  std::vector<uint8_t> present;
  std::vector<glm::dvec3> lit;                // linear radiance, unclamped: ambient + emission + light
  std::vector<glm::dvec3> diffuse, specular;  // light sums; diffuse without albedo
  std::vector<glm::dvec3> albedo;             // linear: base colour x (1 - metal)
  std::vector<double> roughness;              // perceptual, 0..1
  std::vector<glm::dvec3> normal;             // world, unit
  std::vector<glm::dvec3> position;           // relative to the camera, world axes and units
  std::vector<Rival> rivals;                  // sorted
  std::vector<glm::dvec3> unshadowed;         // light if nothing hid any; empty: no light has a shadow
  std::vector<glm::dvec3> mirrored_light;     // the lights' part of what is mirrored; empty: nothing is

  size_t pixels() const { return static_cast<size_t>(size.x) * static_cast<size_t>(size.y); }
  glm::dvec3 light(size_t i) const {  // without ambient and emission
    return albedo[i] * diffuse[i] + specular[i] + (mirrored_light.empty() ? glm::dvec3(0) : mirrored_light[i]);
  }
};

// What a set-up made of it, as read back from its float targets. An empty list: not stored, so not judged.
struct Drawn {
  std::vector<glm::vec3> lit;
  std::vector<glm::vec3> shown;     // lit with what is drawn forward over it
  std::vector<glm::vec3> unlit;     // lit of the same frame without any light: lit - unlit is the light alone
  std::vector<glm::vec3> normal;    // decoded, world
  std::vector<glm::vec3> position;  // decoded, relative to the camera
  std::vector<SeenSurface> seen;    // as the frame's depth has it
  std::vector<float> depth;         // window depth as it is stored
};

}  // namespace gbl
