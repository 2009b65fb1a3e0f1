#include "ui/history.h"

namespace gbl::ui {
namespace {

// The window's doing, and what runs by itself, are no steps.
Settings by_hand(Settings s) {
  s.size = {};
  s.time_s = 0;
  return s;
}

}  // namespace

void History::see(const Settings& now) {
  const bool changed = any_ && !(by_hand(now) == by_hand(seen_));
  if (changed && !changing_) {
    past_.push_back(seen_);
    if (past_.size() > kMost) past_.pop_front();
  }
  if (changed) future_.clear();
  changing_ = changed;
  seen_ = now;
  any_ = true;
}

bool History::undo(Settings& s) {
  if (past_.empty()) return false;
  future_.push_back(s);
  const glm::ivec2 size = s.size;
  s = past_.back();
  s.size = size;
  past_.pop_back();
  seen_ = s, changing_ = false;
  return true;
}

bool History::redo(Settings& s) {
  if (future_.empty()) return false;
  past_.push_back(s);
  const glm::ivec2 size = s.size;
  s = future_.back();
  s.size = size;
  future_.pop_back();
  seen_ = s, changing_ = false;
  return true;
}

}  // namespace gbl::ui
