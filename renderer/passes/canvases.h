#pragma once
// What is drawn beside a frame: the pictures for the eye, what is composed over it, counted, judged and probed. Each is
// made at first use. They are not part of the frame's own memory.
#include <array>
#include <optional>

#include "renderer/inspect/views.h"
#include "renderer/passes/canvas.h"
#include "renderer/passes/frame_textures.h"

namespace gbl {

class Canvases {
 public:
  // The frame's textures were remade: some of these share its depth, all have its size.
  void forget(glm::ivec2 new_size);
  void next_frame() {
    composed_valid = counts_valid = counts_lit_valid = ids_valid = surfaces_valid = redrawn_valid = false;
  }

  Canvas& view(View);                    // RGBA8
  void show_squares(bool);               // their pixels, where they are magnified; else smooth
  const Canvas* drawn_view(View) const;  // null if never drawn at this size
  // RGBA32F with a copy of the scene's depth: lit + what is drawn forward after it
  Canvas& composed(const FrameTextures&);
  // What `final` shows: composed() if anything was drawn over `lit`.
  const gl::Texture& shown(const FrameTextures&) const;
  // RGBA32F: pairs tested, shaded, in range; with the lighting's depth, or with one of its own where forward shading
  // draws anew
  Canvas& counts(const FrameTextures&);
  const gl::Framebuffer& counts_with_depth(const FrameTextures&);
  Canvas& counts_lit();
  // RGBA32F, of objects that are drawn once more (redrawn.cpp), each with the same depth of its own
  Canvas& redrawn_counts();
  Canvas& redrawn_triangles();
  Canvas& unblurred();                // RGBA32F: `lit` before its edges are blurred
  Canvas& ids(const FrameTextures&);  // R32UI with the frame's depth: number of the object, from 1
  Canvas& count_sums();               // the reduction
  Canvas& probe();
  Canvas& numbers(glm::ivec2 size);  // RGBA32F: a view's numbers
  Canvas& errors();                  // RGBA32F: see renderer/truth/error_stats.h
  // RGBA32F: object from 1, triangle from 0, drawn anew with a depth like the frame's
  struct Surfaces {
    gl::Texture seen, depth;
    gl::Framebuffer framebuffer;
  };
  Surfaces& surfaces(const FrameTextures&);
  // Those that are made already:
  const Canvas& counts() const { return *counts_; }
  const Canvas& ids() const { return *ids_; }
  const Canvas& errors() const { return *errors_; }
  const Canvas& numbers() const { return *numbers_; }

  // Of the frame drawn last:
  bool composed_valid = false, counts_valid = false, counts_lit_valid = false, ids_valid = false;
  bool surfaces_valid = false, redrawn_valid = false;

 private:
  glm::ivec2 size_{0};
  std::array<std::optional<Canvas>, kViewCount> views_;
  std::optional<Canvas> redrawn_counts_, redrawn_triangles_;
  std::optional<Canvas> composed_, counts_, counts_lit_, count_sums_, probe_, unblurred_, ids_, errors_, numbers_;
  std::optional<Surfaces> surfaces_;
  bool squares_ = false;
  const gl::Texture& redrawn_depth();
  gl::Texture counts_depth_, composed_depth_, redrawn_depth_;
  gl::Framebuffer counts_with_depth_;
};

}  // namespace gbl
