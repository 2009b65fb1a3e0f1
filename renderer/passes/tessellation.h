#pragma once
// Objects with height maps as the triangles that tessellation makes of them. They are captured once and drawn by all passes
// like any other mesh, and the reference is of the very same triangles.
#include <memory>
#include <vector>

#include "renderer/frame/resolved_frame.h"
#include "renderer/gl/buffer.h"
#include "renderer/gl/object.h"
#include "renderer/gl/texture.h"
#include "renderer/passes/gpu_scene.h"
#include "renderer/passes/programs.h"

namespace gbl {

class Tessellation {
 public:
  struct Object {
    int instance = 0;    // from 0
    gl::Buffer corners;  // Vertex each, three a triangle
    gl::VertexArray vertex_array;
    gl::Object<gl::Kind::transform_feedback> captured;  // knows how many, so that a draw need not ask
    gl::Object<gl::Kind::query> written;
  };

  // Makes the triangles of this frame, if those that it holds are others. -> draw calls
  int update(ProgramCache&, const ResolvedFrame&, const GpuScene&);
  // Null: the object is drawn as it is.
  const Object* of_mesh(const GpuScene&, int mesh) const;
  double mib() const;
  int made() const { return made_; }  // how often its triangles have become others

  // The scene as it is drawn: these objects' meshes are their triangles, and have no height map any more. Waits for the GPU.
  // Where nothing is tessellated, the scene itself.
  std::shared_ptr<const Scene> drawn(const GpuScene&) const;

 private:
  Object capture(ProgramCache&, const ResolvedFrame&, const GpuScene&, int instance) const;
  std::vector<Object> objects_;
  // Without a framebuffer that is complete nothing is captured, although nothing is drawn either.
  gl::Texture pixel_;
  gl::Framebuffer framebuffer_;
  // What they were made for:
  std::weak_ptr<const Scene> scene_;
  Settings settings_;
  int reloads_ = 0;  // of the programs
  int made_ = 0;
};

}  // namespace gbl
