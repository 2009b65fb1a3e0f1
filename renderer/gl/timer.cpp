#include "renderer/gl/timer.h"

#include <chrono>

#include "renderer/gl/device.h"

namespace gbl::gl {
namespace {

double now_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool queries() { return device().features.has(Feature::timer_query); }

}  // namespace

const char* time_source() {
  if (!queries()) return "cpu-clock";
  return device().software ? "software-rasteriser" : "gpu-query";
}

// Mesa's llvmpipe bins the work of a framebuffer into one scene: a query that begins after a clear or draw on the
// same binding sees only the last tile (0.1 ms for a pass of 60 ms). So a flush right after the query begins and
// another before it ends put each pass into scenes of its own. A query that begins while no scene is open (at
// start-up, after a read-back) gets no starting time at all, and the answer is the machine's uptime: so a texel of
// our own is cleared first, which opens one.
void PassTimers::begin(const char* pass) {
  Frame& frame = frames_[current_];
  if (frame.used == frame.slots.size()) frame.slots.emplace_back();
  Slot& slot = frame.slots[frame.used];
  slot.pass = pass;
  if (queries()) {
    if (!slot.query) slot.query = Object<Kind::query>::make();
    if (!anchor_framebuffer_) {
      anchor_ = make_texture({.label = "timer"});
      anchor_framebuffer_ = make_framebuffer({.colours = {&anchor_}, .label = "timer"});
    }
    glBindFramebuffer(GL_FRAMEBUFFER, anchor_framebuffer_.id());
    constexpr float kNothing[4] = {};
    glClearBufferfv(GL_COLOR, 0, kNothing);
    glBeginQuery(GL_TIME_ELAPSED, slot.query.id());
    glFlush();
  } else {
    glFinish();
    cpu_begin_ms_ = now_ms();
  }
}

void PassTimers::end() {
  Frame& frame = frames_[current_];
  Slot& slot = frame.slots[frame.used++];
  if (queries()) {
    glFlush();
    glEndQuery(GL_TIME_ELAPSED);
  } else {
    glFinish();
    slot.cpu_ms = now_ms() - cpu_begin_ms_;
  }
}

void PassTimers::next_frame() {
  const long long number = frames_[current_].number + 1;
  current_ = (current_ + 1) % kFramesUnderWay;
  frames_[current_].used = 0;
  frames_[current_].number = number;
}

std::optional<std::vector<PassTime>> PassTimers::answer_of(Frame& frame, bool wait) const {
  std::vector<PassTime> times;
  for (size_t i = 0; i < frame.used; ++i) {
    const Slot& slot = frame.slots[i];
    double ms = slot.cpu_ms;
    if (queries()) {
      GLint ready = 0;
      if (!wait) glGetQueryObjectiv(slot.query.id(), GL_QUERY_RESULT_AVAILABLE, &ready);
      if (!wait && !ready) return {};
      GLuint64 ns = 0;
      glGetQueryObjectui64v(slot.query.id(), GL_QUERY_RESULT, &ns);
      ms = static_cast<double>(ns) * 1e-6;
    }
    if (!times.empty() && times.back().pass == slot.pass)
      *times.back().ms += ms;  // several views in a row
    else
      times.push_back({slot.pass, ms});
  }
  return times;
}

std::vector<PassTime> PassTimers::collect(bool wait) {
  for (int back = 0; back < kFramesUnderWay; ++back) {
    Frame& frame = frames_[(current_ + kFramesUnderWay - back) % kFramesUnderWay];
    if (frame.used == 0 || frame.number < answered_) continue;  // never back to an older one
    if (auto times = answer_of(frame, wait)) {
      newest_ = std::move(*times);
      answered_ = frame.number;
      break;
    }
  }
  return newest_;
}

PassScope::PassScope(PassTimers& timers, const char* pass) : timers_(timers) {
  if (device().features.has(Feature::debug_labels)) glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, pass);
  timers_.begin(pass);
}

PassScope::~PassScope() {
  timers_.end();
  if (device().features.has(Feature::debug_labels)) glPopDebugGroup();
}

}  // namespace gbl::gl
