#pragma once
// Reports milliseconds of GPU work per pass, or nothing when it cannot; never zero for unknown.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "renderer/frame/frame_report.h"
#include "renderer/gl/texture.h"

namespace gbl::gl {

// How the times of this device may be called: "gpu-query", "software-rasteriser" or "cpu-clock".
const char* time_source();

// Times of the passes of one frame; several frames may be under way. Without timer queries the CPU clock around
// a glFinish is used, and time_source() says so.
class PassTimers {
 public:
  // Begin before the pass binds its framebuffer; see the note in timer.cpp.
  void begin(const char* pass);
  void end();
  void next_frame();

  // The newest frame that has answered entirely; `wait` blocks until the frame just drawn has.
  std::vector<PassTime> collect(bool wait);

  // Frames are numbered from 1: the one begun last, and the one that collect() gave last (0: none yet).
  long long frame() const { return frames_[current_].number; }
  long long answered() const { return answered_; }

 private:
  static constexpr int kFramesUnderWay = 4;
  struct Slot {
    std::string pass;
    Object<Kind::query> query;
    double cpu_ms = 0;
  };
  struct Frame {
    std::vector<Slot> slots;  // reused: no allocation in the steady state
    size_t used = 0;
    long long number = 0;
  };
  std::optional<std::vector<PassTime>> answer_of(Frame&, bool wait) const;

  std::array<Frame, kFramesUnderWay> frames_;
  int current_ = 0;
  double cpu_begin_ms_ = 0;
  Texture anchor_;  // see begin()
  Framebuffer anchor_framebuffer_;
  std::vector<PassTime> newest_;
  long long answered_ = 0;
};

class PassScope {
 public:
  PassScope(PassTimers&, const char* pass);  // also a debug group of this name
  ~PassScope();
  PassScope(const PassScope&) = delete;

 private:
  PassTimers& timers_;
};

}  // namespace gbl::gl
