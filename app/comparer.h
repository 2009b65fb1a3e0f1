#pragma once
// B beside the window's A: other settings drawn into targets of their own, the truth, or a picture from a file; and how far
// the two are apart.
#include <memory>
#include <optional>

#include "app/lab.h"

namespace gbl {

class Comparer {
 public:
  explicit Comparer(Lab& lab) : lab_(lab) {}
  // Once a frame, after A's views are drawn. `a_drawn`: the compared view's picture is another one than in the last
  // frame; `truth_drawn`: the reference's is of this frame.
  void update(const std::optional<ui::CompareRequest>&, bool a_drawn, bool truth_drawn);
  const ui::CompareInput* input() const { return asked_ ? &shown_ : nullptr; }
  bool waiting() const { return waiting_; }

 private:
  void draw_b(View);
  const gl::Texture* picture_of_b(View, bool truth_drawn);  // null, and `missing` says why
  void open_picture();
  void find_difference(View, const gl::Texture& b);
  void take_stats();

  Lab& lab_;
  std::optional<ui::CompareRequest> asked_;
  ui::CompareInput shown_;
  std::unique_ptr<Targets> targets_;  // of B, while settings are compared
  std::optional<gl::Texture> picture_;
  std::string opened_;  // its file
  std::optional<Canvas> errors_, coloured_;
  gl::AsyncRead read_;
  bool waiting_ = false;
};

}  // namespace gbl
