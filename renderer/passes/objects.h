#pragma once
// Drawing the scene's objects: instance records, materials and batches, for the geometry pass and the forward pass.
#include <functional>
#include <vector>

#include "renderer/passes/passes.h"

namespace gbl {

// One draw: instances first … first + count - 1 of those written.
struct ObjectDraw {
  const GpuScene::Batch* batch;
  int first, count;
  int object =
      -1;  // if it is one alone, from 0: of its mesh only the parts in view are drawn, nearest first. -1: all parts are
  bool blended = false;  // its parts are drawn farthest first
};

// Writes the instances' records and says what to draw: objects that may be in view. Opaque: batches and their instances as draw-order says.
// Transparent: one draw per instance, farthest first.
std::vector<ObjectDraw> prepare_objects(Frame&, bool transparent);
// One of them.
std::vector<ObjectDraw> prepare_object(Frame&, int object);
// Opaque ones, relative to another place of the world than the camera's.
std::vector<ObjectDraw> prepare_casters(Frame&, const glm::dvec3& origin);

// How corners reach the vertex shader: shared by indices, or one by one, which numbers the triangles (TRIANGLE_IDS).
enum class Corners { shared, numbered };
// Which faces are drawn: those that the geometry pass keeps; those that it culls, and nothing else; back faces, and all of
// double-sided materials; all.
enum class ObjectFaces { kept, culled, back, all };

// Draw with the given fragment shader; defines of the material are added; `set_uniforms` sets what else the shader
// reads. -> draw calls
int draw_objects(const Frame&, const std::vector<ObjectDraw>&, const char* fragment, const gl::Defines&,
                 const std::function<void(const gl::Program&)>& set_uniforms = {}, Corners = Corners::shared,
                 ObjectFaces = ObjectFaces::kept);

}  // namespace gbl
