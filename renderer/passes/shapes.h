#pragma once
// Meshes that every frame shares: the full-screen triangle and the light volumes.
#include <array>
#include <optional>

#include "renderer/gl/buffer.h"
#include "renderer/light/light_volume.h"

namespace gbl {

struct GpuVolume {
  gl::Buffer vertices, triangles, edges;
  gl::VertexArray solid, wire;
  GLsizei triangle_indices = 0, edge_indices = 0;
};

class Shapes {
 public:
  const GpuVolume& volume(VolumeShape, VolumeLevel);  // a sphere or a cone, made at first use
  void draw_fullscreen(int instances = 1);            // with the bound program and framebuffer
  void draw_generated(int vertices, int instances);   // triangles from gl_VertexID alone

 private:
  std::array<std::array<std::optional<GpuVolume>, 5>, 2> volumes_;
  gl::VertexArray empty_;
};

}  // namespace gbl
