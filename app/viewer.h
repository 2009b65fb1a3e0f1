#pragma once
// What the window does between two frames, without the window: when to draw, at which size, and what to say. Kept
// apart from GLFW so that it can be tested on a headless context.
#include <string>

#include "app/lab.h"

namespace gbl {

class Viewer {
 public:
  explicit Viewer(Lab& lab) : lab_(lab) {}

  // Draws what the requests ask for and what has changed, nothing else. Never throws for a bad setting or shader:
  // the message says what is wrong and the old picture stays.
  void update(const Settings&, const ui::Requests&, bool moving);
  ui::Input input(double seconds) const;
  void say(std::string message) { message_ = std::move(message); }

  // Is there more to come without any input: an answer under way, a smaller picture to be replaced?
  bool busy() const { return waiting_ || moving_; }

 private:
  void draw_frame(const Settings&, bool moving);
  void draw_views(const Settings&, const ui::Requests&, bool all);
  void reload(const Settings&);
  Settings affordable(const Settings&, bool moving);

  Lab& lab_;
  Settings asked_;       // of the last attempt, drawn or refused
  bool attempted_ = false, waiting_ = false, moving_ = false, reduced_ = false;
  std::array<bool, kViewCount> fresh_{};  // views that show the frame drawn last
  Settings::View view_drawn_;
  std::optional<ui::PixelProbe> probe_;
  std::optional<glm::ivec2> probe_asked_;
  std::string message_, banner_;
  long long shaders_ = 0;
};

}  // namespace gbl
