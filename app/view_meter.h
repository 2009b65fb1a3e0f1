#pragma once
// What the numbers of the shown views are like: asked of the GPU, answered some frames later, or at once for files.
#include <array>
#include <optional>

#include "renderer/passes/frame.h"

namespace gbl {

class ViewMeter {
 public:
  // Of the frame just drawn. The answer before stays until the next is there.
  void ask(View, Renderer&, const Settings&, const GpuScene&, Targets&, const ViewOptions&);
  bool take(View, bool wait);  // true: a new answer
  bool waiting(View v) const { return asked_[static_cast<size_t>(v)].pending(); }
  const ViewStats* of(View) const;  // null: never asked
  void forget();                    // another scene: nothing is known of it

 private:
  std::array<gl::AsyncRead, kViewCount> asked_;
  std::array<std::optional<ViewStats>, kViewCount> known_;
};

}  // namespace gbl
