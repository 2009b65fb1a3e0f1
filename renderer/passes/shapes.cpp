#include "renderer/passes/shapes.h"

#include "renderer/light_volume.h"

namespace gbl {
namespace {

Sphere make_sphere(int level) {
  const VolumeMesh mesh = icosphere(level);
  const auto indices = [](const std::vector<uint32_t>& list, const char* label) {
    return gl::make_buffer(GL_ELEMENT_ARRAY_BUFFER, list.data(), list.size() * sizeof(uint32_t), label);
  };
  Sphere s;
  s.vertices =
      gl::make_buffer(GL_ARRAY_BUFFER, mesh.vertices.data(), mesh.vertices.size() * sizeof(glm::vec3), "volume");
  s.triangles = indices(mesh.triangles, "volume.triangles");
  s.edges = indices(mesh.edges, "volume.edges");
  s.solid = gl::make_vertex_array(s.vertices, sizeof(glm::vec3), {{0, 3, 0}}, &s.triangles);
  s.wire = gl::make_vertex_array(s.vertices, sizeof(glm::vec3), {{0, 3, 0}}, &s.edges);
  s.triangle_indices = static_cast<GLsizei>(mesh.triangles.size());
  s.edge_indices = static_cast<GLsizei>(mesh.edges.size());
  return s;
}

}  // namespace

const Sphere& Shapes::sphere(VolumeLevel level) {
  auto& s = spheres_[static_cast<size_t>(level)];
  if (!s) s = make_sphere(static_cast<int>(level));
  return *s;
}

void Shapes::draw_fullscreen() {
  if (!empty_) empty_ = gl::make_empty_vertex_array();
  glBindVertexArray(empty_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Shapes::draw_generated(int vertices, int instances) {
  if (!empty_) empty_ = gl::make_empty_vertex_array();
  glBindVertexArray(empty_.id());
  glDrawArraysInstanced(GL_TRIANGLES, 0, vertices, instances);
}

}  // namespace gbl
