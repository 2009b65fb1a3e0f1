#pragma once
// Trees for built-in scenes, in metres, standing at y = 0 (roots go below).
#include <cstdint>

#include "renderer/scene/scene.h"

namespace gbl {

struct Tree {
  Mesh wood;     // trunk and boughs; bark runs along v
  Mesh foliage;  // a crown of overlapping rounds
};

struct TreeShape {
  double height = 6;    // to the top of the crown
  double trunk = 2.2;   // to where the crown begins
  double radius = 0.2;  // of the trunk above its roots
  double crown = 2;     // radius of the crown
  int rounds = 11;      // in the crown
  uint64_t seed = 1;
};
Tree make_tree(const TreeShape&);

// A trunk alone, with roots that spread and a surface that is nowhere round: for close-ups.
Mesh make_old_trunk(double height, double radius, uint64_t seed);

}  // namespace gbl
