#pragma once
// Ties: pixels where frame and reference see different surfaces at an edge, or where surfaces touch or cut each other, and
// neither can be blamed. A rasteriser moves corners to a grid finer than pixels, and depth has steps. A tie is a pixel
// where the reference itself, shot one step of that grid aside of the centre, sees what the frame shows, or has it right
// behind what it sees. A frame that shows anything else is wrong. The driver's word for the reference's own triangles is
// taken within the same bounds (check_triangles.cpp): had it named the frame's surface there, that would be the truth.
#include <span>

#include "renderer/truth/truth.h"

namespace gbl {

struct Scene;
struct Settings;

// A step of the coarsest grid that is allowed: SUBPIXEL_BITS is at least 4 in OpenGL 3.3 and OpenGL ES 3.0. Most devices
// have 8; the promised number is taken, so that what is a tie does not depend on the device that asks.
inline constexpr double kRasterPx = 1.0 / 16;
// Of the range: surfaces that near to each other are one to a depth buffer of 24 bits up to 1700 times the near plane. A
// coarser one is not excused.
inline constexpr double kSameRange = 1e-4;

// Surfaces besides those that are `seen` within these bounds, background included: by the pixel, each once.
std::vector<Rival> rivals_of(const Settings&, const Scene&, std::span<const SeenSurface> seen);
// The same place by place, for those who do something else in between: what is seen aside of the pixels' centres, added as it
// is found; and then put in order.
inline constexpr int kRivalPlaces = 9;
void add_rivals(int place, const Settings&, const Scene&, std::span<const SeenSurface> seen, std::vector<Rival>&);
void put_in_order(std::vector<Rival>&);

// A truth without rivals knows no ties.
bool is_tie(const Truth&, size_t pixel, SeenSurface frames);

}  // namespace gbl
