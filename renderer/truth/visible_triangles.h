#pragma once
// What is seen through each pixel, found on the CPU in double: no driver is asked. It costs one pass over all
// triangles, whatever the picture's size.
#include <vector>

#include "renderer/truth/truth_geometry.h"

namespace gbl {

// size.x * size.y of the settings, rows top to bottom. Textures are read at their nearest texel, without a normal map:
// good enough to meter a scene by, not for a reference. Without textures only the triangles are told.
std::vector<SeenTexel> visible_triangles(const Settings&, const Scene&, bool with_textures = true);

// What is seen beside the pixels' centres, so many pixels to the right and down: the nearest surface, and those at most
// this share of its range behind it. Of each pixel one at least; in no order.
std::vector<Rival> seen_aside(const Settings&, const Scene&, glm::dvec2 aside_px, double same_range);

// Does any pixel see a surface? With back faces: those of one-sided materials count, too.
bool sees_surface(const Settings&, const Scene&, bool back_faces_too);

// No driver's word is taken for which triangle is seen: the pixel's ray must meet it, and no other before it, within
// what a rasteriser may move a corner. Where it does not, the triangle is looked up; where none is found, this is an
// Error(unfinished) that names the pixel. What textures hold stays as given. Gives the number of triangles replaced.
size_t check_triangles(const Settings&, const Scene&, std::vector<SeenTexel>&);

}  // namespace gbl
