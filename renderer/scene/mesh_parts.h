#pragma once
// A mesh in the order it is drawn in: neighbouring triangles follow each other, so that few corners are worked out twice, and a
// large mesh is cut into parts that lie together, so that what is out of view is not drawn, and the nearest first.
#include <cstdint>
#include <vector>

#include "renderer/scene/scene.h"

namespace gbl {

struct MeshPart {
  uint32_t first, count;  // indices
  Bounds box;             // in the object's coordinates
};
struct MeshInParts {
  std::vector<uint32_t> vertices;  // the mesh's, as triangles first use them; what none uses is left out
  std::vector<uint32_t> indices;   // of the mesh's triangles, into `vertices`
  std::vector<MeshPart> parts;
};

inline constexpr size_t kPartTriangles = 1024;

// One part if it has fewer than four times kPartTriangles.
MeshInParts in_parts(const Mesh&);

}  // namespace gbl
