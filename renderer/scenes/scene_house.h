#pragma once
// A small house for built-in scenes, in metres: 5.2 wide (X), 4 deep (Z), 4.5 high, standing at the origin, its door
// towards +Z. One mesh per material.
#include "renderer/scene/scene.h"

namespace gbl {

struct House {
  Mesh walls;  // bricks, 1 m a tile
  Mesh roof;   // roof tiles, 2 m a tile
  Mesh wood;   // door, frames, gutters
  Mesh panes;
};
House make_house();

}  // namespace gbl
