#pragma once
// How long something takes by a clock that never goes back.
#include <chrono>

namespace gbl {

class Stopwatch {
 public:
  double ms() const { return std::chrono::duration<double, std::milli>(Clock::now() - begun_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begun_ = Clock::now();
};

}  // namespace gbl
