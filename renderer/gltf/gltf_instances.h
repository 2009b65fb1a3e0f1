#pragma once
// Nodes with meshes as instances: each (mesh, skin) is built once, when first met, and shared by all its nodes.
#include <vector>

#include "renderer/gltf/gltf_materials.h"
#include "renderer/gltf/gltf_nodes.h"

namespace gbl::gltf {

void add_instances(const Document&, const std::vector<PlacedNode>&, Materials&, Scene&, Job&);

// Is there something that we do not draw, but that is no fault of the file: points or lines?
bool has_points_or_lines(const Document&, const std::vector<PlacedNode>&);

}  // namespace gbl::gltf
