#include "renderer/passes/canvases.h"

#include "renderer/inspect/pixel_probe.h"
#include "renderer/passes/frame_block.h"

namespace gbl {
namespace {

Canvas& made(std::optional<Canvas>& canvas, const gl::TextureDesc& desc, const gl::Texture* depth = nullptr) {
  if (!canvas) canvas = make_canvas(desc, depth);
  return *canvas;
}

}  // namespace

Canvas make_canvas(const gl::TextureDesc& desc, const gl::Texture* depth) {
  Canvas c;
  c.texture = gl::make_texture(desc);
  c.framebuffer = gl::make_framebuffer({.colours = {&c.texture}, .depth = depth, .label = desc.label});
  return c;
}

Canvas copied(const Canvas& from, bool squares) {
  Canvas to = make_canvas({.size = from.texture.size, .linear_filter = !squares, .label = "copy"});
  const auto [w, h] = std::pair(from.texture.size.x, from.texture.size.y);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer.id());
  glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return to;
}

void Canvases::forget(glm::ivec2 new_size) {
  for (auto* c : {&composed_, &ids_, &counts_}) c->reset();  // they share depth attachments
  counts_with_depth_ = {}, counts_depth_ = {};
  surfaces_.reset();
  if (size_ == new_size) return;
  for (auto& v : views_) v.reset();
  for (auto* c : {&counts_lit_, &count_sums_, &unblurred_, &errors_, &redrawn_counts_, &redrawn_triangles_}) c->reset();
  redrawn_depth_ = {};
  size_ = new_size;
}

Canvas& Canvases::view(View v) {
  std::optional<Canvas>& canvas = views_[static_cast<int>(v)];
  const bool is_new = !canvas;
  made(canvas, {.size = size_, .format = Format::rgba8, .linear_filter = true, .label = row(v).id});
  if (is_new) gl::magnify_squares(canvas->texture, squares_);
  return *canvas;
}

void Canvases::show_squares(bool on) {
  if (on == squares_) return;
  squares_ = on;
  for (const auto& canvas : views_)
    if (canvas) gl::magnify_squares(canvas->texture, on);
}

const Canvas* Canvases::drawn_view(View v) const {
  const auto& canvas = views_[static_cast<int>(v)];
  return canvas ? &*canvas : nullptr;
}

Canvas& Canvases::composed(const FrameTextures& frame) {
  if (!composed_)
    composed_depth_ =
        gl::make_texture({.size = size_, .format = frame.texture(Stores::depth)->format, .label = "composed.depth"});
  return made(composed_, {.size = size_, .format = Format::rgba32f, .label = "composed"}, &composed_depth_);
}

const gl::Texture& Canvases::shown(const FrameTextures& frame) const {
  return composed_valid ? composed_->texture : *frame.texture(Stores::lit);
}

Canvas& Canvases::counts(const FrameTextures& frame) {
  return made(counts_, {.size = size_, .format = Format::rgba32f, .label = "counts"},
              frame.texture(Stores::light_depth));
}
const gl::Framebuffer& Canvases::counts_with_depth(const FrameTextures& frame) {
  if (!counts_with_depth_) {
    counts_depth_ = gl::make_texture({.size = size_, .format = Format::d32f, .label = "counts.depth"});
    counts_with_depth_ =
        gl::make_framebuffer({.colours = {&counts(frame).texture}, .depth = &counts_depth_, .label = "counts"});
  }
  return counts_with_depth_;
}
const gl::Texture& Canvases::redrawn_depth() {
  if (!redrawn_depth_.name)
    redrawn_depth_ = gl::make_texture({.size = size_, .format = Format::d32f, .label = "redrawn.depth"});
  return redrawn_depth_;
}
Canvas& Canvases::redrawn_counts() {
  return made(redrawn_counts_, {.size = size_, .format = Format::rgba32f, .label = "redrawn.counts"}, &redrawn_depth());
}
Canvas& Canvases::redrawn_triangles() {
  return made(redrawn_triangles_, {.size = size_, .format = Format::rgba32f, .label = "redrawn.triangles"},
              &redrawn_depth());
}
Canvas& Canvases::unblurred() {
  return made(unblurred_, {.size = size_, .format = Format::rgba32f, .label = "unblurred"});
}
Canvas& Canvases::ids(const FrameTextures& frame) {
  return made(ids_, {.size = size_, .format = Format::r32ui, .label = "ids"}, frame.texture(Stores::depth));
}
Canvases::Surfaces& Canvases::surfaces(const FrameTextures& frame) {
  if (surfaces_) return *surfaces_;
  Surfaces& s = surfaces_.emplace();
  s.seen = gl::make_texture({.size = size_, .format = Format::rgba32f, .label = "surfaces"});
  s.depth =
      gl::make_texture({.size = size_, .format = frame.texture(Stores::depth)->format, .label = "surfaces.depth"});
  s.framebuffer = gl::make_framebuffer({.colours = {&s.seen}, .depth = &s.depth, .label = "surfaces"});
  return s;
}
Canvas& Canvases::counts_lit() {
  return made(counts_lit_, {.size = size_, .format = Format::r32f, .label = "counts.lit"});
}
Canvas& Canvases::count_sums() {
  return made(count_sums_,
              {.size = (size_ + COUNT_BLOCK - 1) / COUNT_BLOCK, .format = Format::rgba32f, .label = "counts.sums"});
}
Canvas& Canvases::errors() { return made(errors_, {.size = size_, .format = Format::rgba32f, .label = "errors"}); }
Canvas& Canvases::numbers(glm::ivec2 size) {
  if (numbers_ && numbers_->texture.size != size) numbers_.reset();
  return made(numbers_, {.size = size, .format = Format::rgba32f, .label = "numbers"});
}
Canvas& Canvases::probe() {
  return made(probe_, {.size = {kProbeFieldCount, 1}, .format = Format::rgba32f, .label = "probe"});
}

}  // namespace gbl
