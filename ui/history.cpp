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

bool History::step(std::deque<Settings>& from, std::deque<Settings>& to, Settings& s) {
  if (from.empty()) return false;
  to.push_back(s);
  const glm::ivec2 size = s.size;
  s = from.back();
  s.size = size;
  from.pop_back();
  seen_ = s, changing_ = false;
  return true;
}

bool History::undo(Settings& s) { return step(past_, future_, s); }
bool History::redo(Settings& s) { return step(future_, past_, s); }

}  // namespace gbl::ui
