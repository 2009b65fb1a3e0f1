#pragma once
// Ctrl+C, and a system that shuts down: what is under way ends early and keeps what it has.
#include <atomic>
#include <csignal>

namespace gbl {

// While one lives the first signal is noted only; a second one ends the program. One at a time.
class InterruptScope {
 public:
  InterruptScope();
  ~InterruptScope();
  InterruptScope(const InterruptScope&) = delete;
  InterruptScope& operator=(const InterruptScope&) = delete;

  const std::atomic<bool>& interrupted() const;

 private:
  static constexpr int kEndings[] = {SIGINT, SIGTERM};
  void (*before_[2])(int);
};

}  // namespace gbl
