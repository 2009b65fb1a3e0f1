#pragma once
// What the settings were: Ctrl+Z and Ctrl+Y. What changes in every frame, a drag or a camera that moves, is one step.
#include <deque>

#include "renderer/options/settings.h"

namespace gbl::ui {

class History {
 public:
  // Once a frame, before anything is changed in it.
  void see(const Settings&);
  // A change that is none to take back: between A and B.
  void pass_over(const Settings& now) { seen_ = now, changing_ = false; }
  const Settings* last() const { return past_.empty() ? nullptr : &past_.back(); }  // before the last change
  // True: there was a step back or forward, and the settings are those now.
  bool undo(Settings&);
  bool redo(Settings&);

 private:
  bool step(std::deque<Settings>& from, std::deque<Settings>& to, Settings&);
  static constexpr size_t kMost = 200;
  std::deque<Settings> past_, future_;  // the nearest at the end
  Settings seen_;                       // of the frame before
  bool any_ = false, changing_ = false;
};

}  // namespace gbl::ui
