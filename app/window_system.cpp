#include "app/window_system.h"

#include <GLFW/glfw3.h>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>

#include "renderer/base/error.h"
#include "renderer/gl/gl.h"

namespace gbl {
namespace {

// The one that shows this point of the desktop, or else the first; null: there is none.
GLFWmonitor* monitor_at(glm::ivec2 point) {
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  for (int i = 0; i < count; ++i) {
    glm::ivec2 at;
    glfwGetMonitorPos(monitors[i], &at.x, &at.y);
    const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
    const glm::ivec2 inside = point - at;
    if (mode && inside.x >= 0 && inside.y >= 0 && inside.x < mode->width && inside.y < mode->height) return monitors[i];
  }
  return count > 0 ? monitors[0] : nullptr;
}

// Xlib ends the program with exit code 1 when its display goes. Asked for by name: GLFW brings the library, or, where
// windows are not X11's, does not.
int display_lost(void*) {
  std::fputs("gbufferlab: window: the display was lost; start it again, pictures that were saved are kept\n", stderr);
  std::_Exit(static_cast<int>(ExitCode::unfinished));
}

}  // namespace

void ask_for_context(gl::Api api) {
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);  // full on a projector, it stays while the other screen is used
  const bool es = api == gl::Api::es3;
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, es ? 0 : 3);
  if (es) {
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    return;
  }
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);  // macOS gives no core profile without it
}

void name_lost_displays() {
  using Handler = int (*)(void*);
  using SetHandler = Handler (*)(Handler);
  if (void* found = dlsym(RTLD_DEFAULT, "XSetIOErrorHandler")) reinterpret_cast<SetHandler>(found)(display_lost);
}

bool wait_for_events(double seconds) {
  const double before = glfwGetTime();
  glfwWaitEventsTimeout(seconds);
  return glfwGetTime() - before < seconds * 0.9;
}

void adjust_imgui(GLFWwindow*) {}
bool wants_less_motion() { return false; }
void show_in_address(const Settings&, const std::string&) {}
void say_in_words(const std::string&) {}
void hand_over(const std::string&) {}

std::string printed_name(int key, int scancode) {
  const char* printed = glfwGetKeyName(key, scancode);
  return printed ? printed : "";
}

float content_scale_of(GLFWwindow* window) {
  glm::vec2 scale(1);
  glfwGetWindowContentScale(window, &scale.x, &scale.y);
  return std::round(scale.x * 4) / 4;  // X11 gives 1.04 for 100 dots per inch
}

void fit_monitor(GLFWwindow* window) {
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (!monitor) return;
  glm::ivec2 at, room, size;
  glfwGetMonitorWorkarea(monitor, &at.x, &at.y, &room.x, &room.y);
  glfwGetWindowSize(window, &size.x, &size.y);
  const glm::ivec2 fitted = glm::min(size, room);
  if (fitted != size && fitted.x > 0 && fitted.y > 0) glfwSetWindowSize(window, fitted.x, fitted.y);
}

bool FullScreen::on(GLFWwindow* window) const { return glfwGetWindowMonitor(window) != nullptr; }

void FullScreen::toggle(GLFWwindow* window) {
  if (on(window)) {
    glfwSetWindowMonitor(window, nullptr, place_.x, place_.y, size_.x, size_.y, GLFW_DONT_CARE);
    return;
  }
  glfwGetWindowPos(window, &place_.x, &place_.y);
  glfwGetWindowSize(window, &size_.x, &size_.y);
  GLFWmonitor* monitor = monitor_at(place_ + size_ / 2);
  const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
  if (!mode) throw Error(ExitCode::unfinished, "full screen", "there is no monitor to fill");
  glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

}  // namespace gbl
