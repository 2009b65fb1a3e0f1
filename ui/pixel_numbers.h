#pragma once
// Single pixels of an enlarged picture: a grid between them, and the view's numbers on them.
#include "ui/text.h"
#include "ui/ui.h"
#include "ui/zoom.h"

namespace gbl::ui {

inline constexpr double kGridFrom = 8, kNumbersFrom = 48;  // screen pixels per pixel of the picture

// The pixels of a frame of this size that are shown, wholly or in part.
PixelGrid shown_pixels(const Zoom&, glm::ivec2 frame);

// Where a pixel takes at least so many screen pixels; both keep inside the picture.
void draw_grid(Painter&, const Box& picture, const Zoom&, glm::ivec2 frame);
// Not larger than `px`.
void draw_numbers(Painter&, const Box& picture, const Zoom&, glm::ivec2 frame, const PixelNumbers&, float px);

}  // namespace gbl::ui
