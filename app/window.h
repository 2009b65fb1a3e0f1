#pragma once
// A GLFW window with a GL 3.3 core context, current while it lives, and the keys pressed in it.
#include <glm/glm.hpp>
#include <set>
#include <string>
#include <vector>

#include "app/window_system.h"
#include "ui/ui.h"

namespace gbl {

class Window {
 public:
  Window(glm::ivec2 size, const char* title, gl::Api = gl::Api::core);  // Error(no_gl) without a display or a usable GL
  ~Window();
  Window(const Window&) = delete;

  bool closing() const;
  void wait_events(double seconds);  // returns at the first event, at latest after so long
  glm::ivec2 framebuffer_size() const;
  float content_scale() const;  // how much larger than usual its monitor wants things; in quarters
  bool full_screen() const;
  void toggle_full_screen();  // and back to where it was; Error where there is no monitor
  void swap();
  GLFWwindow* handle() const { return window_; }

  std::vector<ui::KeyEvent> take_keys();  // since the last call
  std::vector<std::string> take_drops();  // files dropped on the window since the last call
  const std::set<std::string>& held() const { return held_; }
  bool saw_input();  // any event since the last call

 private:
  static void notice(GLFWwindow*);
  static void on_key(GLFWwindow*, int key, int scancode, int action, int mods);
  static void on_character(GLFWwindow*, unsigned codepoint);
  static void on_drop(GLFWwindow*, int count, const char** paths);
  GLFWwindow* window_ = nullptr;
  FullScreen full_screen_;
  std::vector<ui::KeyEvent> keys_;
  std::vector<std::string> drops_;
  std::set<std::string> held_;
  bool input_ = true;
};

}  // namespace gbl
