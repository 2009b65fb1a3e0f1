#pragma once
// A scene on the GPU: what does not change from frame to frame. Several frames of different settings may share it.
#include <memory>
#include <vector>

#include "renderer/gl/buffer.h"
#include "renderer/gl/texture.h"
#include "renderer/options/settings.h"
#include "renderer/scene/mesh_parts.h"
#include "renderer/scene/scene.h"

namespace gbl {

// That reads an array of Vertex.
gl::VertexArray vertex_array_of(const gl::Buffer& vertices, const gl::Buffer* indices);

class GpuScene {
 public:
  explicit GpuScene(std::shared_ptr<const Scene> scene);
  const Scene& scene() const { return *scene_; }
  std::shared_ptr<const Scene> shared_scene() const { return scene_; }  // for work on other threads

  struct GpuMesh {
    gl::Buffer vertices, indices;
    gl::VertexArray vertex_array;
    GLsizei index_count = 0;
    std::vector<MeshPart> parts;  // of the indices; none of what has no indices
    // To be drawn: shaders read a plain vertex' colour and coordinates of a mesh that stores none. GL forgets them at each
    // draw of a mesh that does.
    void bind() const;
  };
  const GpuMesh& mesh(int i) const { return meshes_[i]; }
  const Bounds& mesh_bounds(int i) const {
    return mesh_bounds_[static_cast<size_t>(i)];
  }  // in the object's coordinates
  // Some of its triangles without shared corners and without indices, so that gl_VertexID / 3 counts them on every
  // device: kPart of them from `first_triangle`. For once: of a large mesh all would take many times its own memory.
  GpuMesh unshared_part(int i, size_t first_triangle) const;
  static constexpr size_t kPart = 16384;  // 3.5 MB

  // Instances that share mesh, material and winding: one draw.
  struct Batch {
    int mesh = 0, material = 0;
    bool mirrored = false;
    std::vector<int> instances;
  };
  const std::vector<Batch>& batches() const { return batches_; }

  // The box about all instances of a batch, in the world.
  const Bounds& bounds(const Batch& b) const { return batch_bounds_[static_cast<size_t>(&b - batches_.data())]; }

  // kNoTexture gives a neutral texel. A colour texture is decoded from sRGB when sampled, except as-tutorial.
  const gl::Texture& colour_texture(int i, Colour) const;
  const gl::Texture& data_texture(int i) const;    // white if none
  const gl::Texture& normal_texture(int i) const;  // flat if none

 private:
  const gl::Texture& uploaded(std::vector<gl::Texture>& set, int i, bool srgb) const;

  std::shared_ptr<const Scene> scene_;
  std::vector<GpuMesh> meshes_;
  std::vector<Bounds> mesh_bounds_;
  std::vector<Batch> batches_;
  std::vector<Bounds> batch_bounds_;
  gl::Texture white_, flat_normal_;
  mutable std::vector<gl::Texture> srgb_, linear_;  // made at first use: a scene may need only one of the two
};

}  // namespace gbl
