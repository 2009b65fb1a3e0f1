// Overlapping layers that face the camera: what forward shading shades many times over and deferred shading once. Each
// nearer layer leaves a strip of the one behind it to be seen, upwards and to the left.
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include "renderer/scenes/builtin_scenes.h"
#include "renderer/scenes/scene_parts.h"

namespace gbl {
namespace {

constexpr int kLayers = 16;
constexpr double kEye = 6, kSpacing = 0.5, kFov = 45;
constexpr double kAspect = 16.0 / 9, kStepRight = 0.042, kStepDown = 0.056;  // in halves of the picture

// Full colours round the circle of hues, 0..1.
glm::dvec3 hue(double h) {
  const auto channel = [h](double shift) {
    const double x = std::abs(std::fmod(h + shift, 1.0) * 6 - 3) - 1;
    return glm::clamp(x, 0.0, 1.0);
  };
  return {channel(0), channel(2.0 / 3), channel(1.0 / 3)};
}

}  // namespace

Scene build_layers() {
  Scene scene;
  scene.name = "layers";
  const SurfaceTextures panels = make_panels(256, 4);
  const TextureUse albedo{add(scene, panels.albedo)}, normal{add(scene, panels.normal)};
  const TextureUse roughness{add(scene, panels.roughness)};
  const int sheet = add(scene, make_sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 10), "layer");
  const double half_height = std::tan(glm::radians(kFov) / 2), half_width = half_height * kAspect;
  for (int i = 0; i < kLayers; ++i) {  // from far to near
    const double z = -(kLayers - 1 - i) * kSpacing, distance = kEye - z;
    const double left = i == 0 ? -1.5 : -1 + i * kStepRight, top = i == 0 ? 1.5 : 1 - i * kStepDown;
    const glm::dvec3 from(left * half_width * distance, -1.5 * half_height * distance, z);
    const glm::dvec3 to(1.5 * half_width * distance, top * half_height * distance, z + 1);
    const glm::dvec3 colour = glm::mix(glm::dvec3(0.75), hue(0.62 * i / (kLayers - 1)), 0.78) * 0.85;
    const int material = add(scene, Material{.name = fmt::format("layer {}", i + 1),
                                             .base_colour = glm::vec4(glm::vec3(colour), 1),
                                             .base_colour_texture = albedo,
                                             .normal_texture = normal,
                                             .roughness_texture = roughness});
    place(scene, fmt::format("layer {}", i + 1), sheet, material,
          glm::scale(glm::translate(glm::dmat4(1), from), to - from));
  }
  scene.bounds = bounds_of(scene);
  scene.light_box = LightBox{{-6, -3.5, -7.5}, {6, 3.5, 3.2}, BoxRange::overlap, 8};
  scene.camera = camera_at({0, 0, kEye}, 0, 0, kFov, 0.1, 100);
  return scene;
}

}  // namespace gbl
