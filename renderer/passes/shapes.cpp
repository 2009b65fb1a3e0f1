#include "renderer/passes/shapes.h"

namespace gbl {
namespace {

GpuVolume upload(const VolumeMesh& mesh) {
  const auto indices = [](const std::vector<uint32_t>& list, const char* label) {
    return gl::make_buffer(GL_ELEMENT_ARRAY_BUFFER, list.data(), list.size() * sizeof(uint32_t), label);
  };
  GpuVolume v;
  v.vertices =
      gl::make_buffer(GL_ARRAY_BUFFER, mesh.vertices.data(), mesh.vertices.size() * sizeof(glm::vec3), "volume");
  v.triangles = indices(mesh.triangles, "volume.triangles");
  v.edges = indices(mesh.edges, "volume.edges");
  const gl::VertexAttribute positions[] = {{0, 3, 0}};
  v.solid = gl::make_vertex_array(v.vertices, sizeof(glm::vec3), positions, &v.triangles);
  v.wire = gl::make_vertex_array(v.vertices, sizeof(glm::vec3), positions, &v.edges);
  v.triangle_indices = static_cast<GLsizei>(mesh.triangles.size());
  v.edge_indices = static_cast<GLsizei>(mesh.edges.size());
  return v;
}

}  // namespace

const GpuVolume& Shapes::volume(VolumeShape shape, VolumeLevel level) {
  auto& v = volumes_[static_cast<size_t>(shape)][static_cast<size_t>(level)];
  if (!v) v = upload(volume_mesh(shape, level));
  return *v;
}

void Shapes::draw_fullscreen(int instances) { draw_generated(3, instances); }

void Shapes::draw_generated(int vertices, int instances) {
  if (!empty_) empty_ = gl::make_empty_vertex_array();
  glBindVertexArray(empty_.id());
  glDrawArraysInstanced(GL_TRIANGLES, 0, vertices, instances);
}

}  // namespace gbl
