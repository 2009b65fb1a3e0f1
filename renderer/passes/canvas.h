#pragma once
// A texture with the framebuffer that draws into it alone.
#include "renderer/gl/texture.h"

namespace gbl {

struct Canvas {
  gl::Texture texture;
  gl::Framebuffer framebuffer;
};
Canvas make_canvas(const gl::TextureDesc&, const gl::Texture* depth = nullptr);
// Keeps a picture that the next draw would overwrite. squares: its pixels, where they are magnified; else smooth
Canvas copied(const Canvas&, bool squares = false);

}  // namespace gbl
