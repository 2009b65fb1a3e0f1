#include "renderer/study/stability/stability_scenes.h"

#include "renderer/scenes/mesh_builder.h"

namespace gbl {
namespace {

Mesh square() {
  Mesh m;
  m.name = "wall";
  for (const glm::vec2 at : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)})
    m.vertices.push_back({.position = {at, 0},
                          .normal = {0, 0, 1},
                          .tangent = {1, 0, 0, 1},
                          .uv = {0.5f * at.x + 0.5f, 0.5f - 0.5f * at.y}});
  m.indices = {0, 1, 2, 0, 2, 3};
  return m;
}

}  // namespace

Settings exact_settings(const std::string& scene_name, glm::ivec2 size) {
  Settings s;
  s.scene = scene_name;
  s.size = size;
  s.lights.source = LightSource::scene;
  s.lights.method = LightMethod::fullscreen;
  s.shading.model = ShadingModel::lambert;
  s.ambient = 0;
  s.background.fill = BackgroundFill::black;
  s.normal_map = NormalMap::off;
  s.layout = Layout::float32;
  s.normal.encoding = NormalEncoding::xyz32f;
  s.position.source = PositionSource::view32f;
  s.accumulation = {AccumulationFormat::rgba32f, AccumulationTargets::one};
  return s;
}

Light lamp(const glm::dvec3& position, double range, double intensity) {
  Light l;
  l.position = position, l.range = range, l.colour = glm::dvec3(intensity);
  return l;
}

SweepSetup wall_setup(const std::string& name, glm::ivec2 size, const glm::dmat4& world_from_wall,
                      std::vector<Light> lights) {
  auto scene = std::make_shared<Scene>();
  scene->name = name;
  scene->meshes = {square()};
  scene->materials = {{.name = "white"}};
  scene->instances = {{"wall", 0, 0, world_from_wall}};
  scene->lights = std::move(lights);
  scene->bounds = bounds_of(*scene);
  return {exact_settings(name, size), std::move(scene)};
}

glm::dmat4 wall_at(const glm::dvec3& middle, double half) {
  glm::dmat4 m(half);
  m[3] = glm::dvec4(middle, 1);
  return m;
}

glm::dmat4 wall_before(const Camera& c, double range) {
  const glm::dmat3 world_from_view(c.right(), c.up(), -c.forward());
  const glm::dmat3 tilted = world_from_view * glm::dmat3(glm::mat3_cast(orientation_from_yaw_pitch(5, 3)));
  glm::dmat4 m(tilted * (1.3 * range));  // a picture of 16:9 at 45 degrees is 0.74 range wide to each side
  m[3] = glm::dvec4(c.position + range * c.forward(), 1);
  return m;
}

}  // namespace gbl
