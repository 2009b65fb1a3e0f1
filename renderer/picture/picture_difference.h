#pragma once
// How far two pictures are apart where a reader would see it.
#include "renderer/picture/image.h"

namespace gbl {

// Both are of one size. The largest difference of a channel's mean over squares of so many pixels a side, in codes of 255.
double largest_square_difference(const Image&, const Image&, int side);

}  // namespace gbl
