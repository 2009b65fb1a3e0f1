#pragma once
// Nodes with meshes as instances: each (mesh, skin) is built once, when first met, and shared by all its nodes.
#include <vector>

#include "renderer/gltf/gltf_materials.h"
#include "renderer/gltf/gltf_nodes.h"

namespace gbl::gltf {

void add_instances(const Document&, const std::vector<PlacedNode>&, Materials&, Scene&, Job&);

// Exact while that takes no longer than loading does, else from each mesh's box.
void set_bounds(Scene&);

}  // namespace gbl::gltf
