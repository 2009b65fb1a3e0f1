#pragma once
// Meshes that every frame shares: the full-screen triangle and the light volumes' spheres.
#include <array>
#include <optional>

#include "renderer/gl/buffer.h"
#include "renderer/settings.h"

namespace gbl {

struct Sphere {
  gl::Buffer vertices, triangles, edges;
  gl::VertexArray solid, wire;
  GLsizei triangle_indices = 0, edge_indices = 0;
};

class Shapes {
 public:
  const Sphere& sphere(VolumeLevel);  // made at first use
  void draw_fullscreen();             // with the bound program and framebuffer
  void draw_generated(int vertices, int instances);  // triangles from gl_VertexID alone

 private:
  std::array<std::optional<Sphere>, 5> spheres_;
  gl::VertexArray empty_;
};

}  // namespace gbl
