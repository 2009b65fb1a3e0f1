#pragma once
// Scenes with a known answer for the reference, and what the GPU would say of them: which triangle a pixel sees.
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "renderer/truth/reference.h"

namespace gbl::test {

inline Vertex corner(glm::vec3 position, glm::vec4 colour = glm::vec4(1)) {
  return {position, {0, 1, 0}, {1, 0, 0, 1}, {0, 0}, {0, 0}, colour};
}

// A level square of this half width at y = 0, facing up; all materials' textures absent.
inline Scene make_plane(float half_width, Material material = {}) {
  Scene s;
  Mesh m{"plane", {}, {0, 2, 1, 1, 2, 3}};
  for (const float z : {-half_width, half_width})
    for (const float x : {-half_width, half_width}) m.vertices.push_back(corner({x, 0, z}));
  s.meshes = {m};
  s.materials = {std::move(material)};
  s.instances = {{"plane", 0, 0, glm::dmat4(1)}};
  return s;
}

inline Light point_light(glm::dvec3 position, double range = kEndless, glm::dvec3 colour = glm::dvec3(1)) {
  Light l;
  l.position = position, l.range = range, l.colour = colour;
  return l;
}

// Lit by the scene's own lights with nothing else: no ambient light, nothing behind.
inline Settings closed_settings(glm::ivec2 size = {32, 18}) {
  Settings s;
  s.size = size;
  s.lights.source = LightSource::scene;
  s.attenuation = Attenuation::none;
  s.shading.model = ShadingModel::lambert;
  s.ambient = 0;
  s.background.fill = BackgroundFill::black;
  s.camera.position = {1, 6, 7};
  s.camera.orientation = orientation_from_yaw_pitch(8, -40);
  s.camera.near = 0.1, s.camera.far = 1000;
  return s;
}

// By rays against all triangles, nearest first: exact, and slow.
inline std::vector<SeenTexel> seen_by_rays(const Scene& scene, const Settings& s) {
  std::vector<SeenTexel> out(static_cast<size_t>(s.size.x) * static_cast<size_t>(s.size.y));
  for (int y = 0; y < s.size.y; ++y)
    for (int x = 0; x < s.size.x; ++x) {
      const Ray ray = pixel_ray(s.camera, s.size, {x, y});
      double nearest = std::numeric_limits<double>::infinity();
      SeenTexel& texel = out[static_cast<size_t>(y) * static_cast<size_t>(s.size.x) + static_cast<size_t>(x)];
      for (size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const Mesh& mesh = scene.meshes[static_cast<size_t>(instance.mesh)];
        for (size_t t = 0; t < mesh.indices.size() / 3; ++t) {
          glm::dvec3 p[3];
          for (size_t k = 0; k < 3; ++k)
            p[k] = glm::dvec3(instance.world_from_object *
                              glm::dvec4(mesh.vertices[mesh.indices[3 * t + k]].position, 1)) -
                   s.camera.position;
          const glm::dvec3 n = glm::cross(p[1] - p[0], p[2] - p[0]);
          const double distance = glm::dot(n, p[0] - ray.origin) / glm::dot(n, ray.direction);
          const glm::dvec3 at = ray.origin + distance * ray.direction;
          bool inside = distance > 0 && distance < nearest;
          for (int k = 0; k < 3 && inside; ++k) inside = glm::dot(glm::cross(p[(k + 1) % 3] - p[k], at - p[k]), n) >= 0;
          if (!inside) continue;
          nearest = distance;
          texel = {{float(i + 1), float(t), 1, 1}, glm::vec4(1), {0.5f, 0.5f, 1, 1}, glm::vec4(1)};
        }
      }
    }
  return out;
}

inline Truth truth_of(const Scene& scene, const Settings& s, int threads = 1) {
  Reference reference(s, std::make_shared<const Scene>(scene), seen_by_rays(scene, s));
  EXPECT_TRUE(reference.run(threads));
  return reference.truth();
}

// |a - b| relative to the larger, or absolute below 1e-12: what double leaves of a closed form.
inline double relative_error(double got, double expected) {
  const double scale = std::max(std::abs(got), std::abs(expected));
  return scale < 1e-12 ? 0 : std::abs(got - expected) / scale;
}

}  // namespace gbl::test
