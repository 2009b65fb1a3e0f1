#pragma once
// The node tree, walked once without recursion: cycles, second parents and endless chains cost nothing.
#include <vector>

#include "renderer/gltf/gltf_document.h"

namespace gbl::gltf {

struct PlacedNode {
  int node = 0;
  glm::dmat4 world_from_node{1};
};

// Nodes of the scene to show, parents first. Each node stands once; what breaks the tree is noted.
std::vector<PlacedNode> place_nodes(const Document&, Job&);

// Lights and the first usable camera of the placed nodes. Without a camera the scene is framed.
void add_lights(const Document&, const std::vector<PlacedNode>&, Scene&, Job&);
void set_camera(const Document&, const std::vector<PlacedNode>&, Scene&, Job&);  // after the bounds

}  // namespace gbl::gltf
