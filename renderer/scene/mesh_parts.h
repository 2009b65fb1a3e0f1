#pragma once
// A large mesh in parts of triangles that lie together, so that what is out of view is not drawn, and the nearest first.
#include <cstdint>
#include <vector>

#include "renderer/scene/scene.h"

namespace gbl {

struct MeshPart {
  uint32_t first, count;  // indices
  Bounds box;             // in the object's coordinates
};
struct MeshInParts {
  std::vector<uint32_t> indices;  // of the same triangles, in another order
  std::vector<MeshPart> parts;
};

inline constexpr size_t kPartTriangles = 1024;

// One part, in the mesh's own order, if it has fewer than four times kPartTriangles.
MeshInParts in_parts(const Mesh&);

}  // namespace gbl
