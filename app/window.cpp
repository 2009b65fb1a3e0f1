#include "app/window.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <utility>

#include "renderer/base/error.h"
#include "renderer/gl/gl.h"

namespace gbl {
namespace {

struct NamedKey {
  int glfw;
  const char* name;
};
constexpr NamedKey kNamedKeys[] = {
    {GLFW_KEY_HOME, "Home"},          {GLFW_KEY_END, "End"},
    {GLFW_KEY_PAGE_UP, "PgUp"},       {GLFW_KEY_PAGE_DOWN, "PgDn"},
    {GLFW_KEY_ENTER, "Enter"},        {GLFW_KEY_KP_ENTER, "Enter"},
    {GLFW_KEY_ESCAPE, "Esc"},         {GLFW_KEY_TAB, "Tab"},
    {GLFW_KEY_SPACE, "Space"},        {GLFW_KEY_LEFT, "Left"},
    {GLFW_KEY_RIGHT, "Right"},        {GLFW_KEY_UP, "Up"},
    {GLFW_KEY_DOWN, "Down"},          {GLFW_KEY_LEFT_SHIFT, "Shift"},
    {GLFW_KEY_RIGHT_SHIFT, "Shift"},  {GLFW_KEY_LEFT_CONTROL, "Ctrl"},
    {GLFW_KEY_RIGHT_CONTROL, "Ctrl"},
};

// Found as characters, since keyboards put them in different places.
constexpr std::string_view kAsCharacters = "+-=[]/";

std::string name_of(int key, int scancode) {
  for (const NamedKey& k : kNamedKeys)
    if (k.glfw == key) return k.name;
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return fmt::format("F{}", key - GLFW_KEY_F1 + 1);
  return printed_name(key, scancode);
}

constexpr glm::ivec2 kLeast{320, 180};  // for window managers; where there is none the screen stays empty below its own

std::string g_last_error;

}  // namespace

Window::Window(glm::ivec2 size, const char* title, gl::Api api) {
  glfwSetErrorCallback([](int, const char* text) { g_last_error = text; });
  if (!glfwInit())
    throw Error(ExitCode::no_gl, "window", fmt::format("no display ({})", g_last_error),
                "start it in a desktop session, or use `render`, which needs none");
  name_lost_displays();
  ask_for_context(api);
  window_ = glfwCreateWindow(size.x, size.y, title, nullptr, nullptr);
  if (!window_) {
    glfwTerminate();
    throw Error(
        ExitCode::no_gl, "window",
        fmt::format("no window with {} ({})", api == gl::Api::es3 ? "OpenGL ES 3.0" : "OpenGL 3.3", g_last_error),
        "install a GL driver; Mesa's software driver is in libgl1-mesa-dri");
  }
  fit_monitor(window_);
  glfwSetWindowSizeLimits(window_, kLeast.x, kLeast.y, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(window_, this);
  glfwSetKeyCallback(window_, on_key);  // before ImGui's back-end, which passes events on to these
  glfwSetCharCallback(window_, on_character);
  glfwSetDropCallback(window_, on_drop);
  // Whatever else happens to it; ImGui's back-end passes these on, too.
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double, double) { notice(w); });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int, int, int) { notice(w); });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double) { notice(w); });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int) { notice(w); });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int) { notice(w); });
  glfwSetWindowRefreshCallback(window_, notice);
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { notice(w); });
}

void Window::notice(GLFWwindow* w) { static_cast<Window*>(glfwGetWindowUserPointer(w))->input_ = true; }

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

bool Window::closing() const { return glfwWindowShouldClose(window_); }

void Window::wait_events(double seconds) {
  if (wait_for_events(seconds)) input_ = true;
}

glm::ivec2 Window::framebuffer_size() const {
  glm::ivec2 size;
  glfwGetFramebufferSize(window_, &size.x, &size.y);
  return size;
}

float Window::content_scale() const { return content_scale_of(window_); }
bool Window::full_screen() const { return full_screen_.on(window_); }
void Window::toggle_full_screen() { full_screen_.toggle(window_); }
void Window::swap() { glfwSwapBuffers(window_); }

std::vector<std::string> Window::take_drops() { return std::exchange(drops_, {}); }
std::vector<ui::KeyEvent> Window::take_keys() { return std::exchange(keys_, {}); }
bool Window::saw_input() { return std::exchange(input_, false); }

void Window::on_key(GLFWwindow* w, int key, int scancode, int action, int mods) {
  notice(w);
  auto& self = *static_cast<Window*>(glfwGetWindowUserPointer(w));
  const std::string name = name_of(key, scancode);
  if (name.empty()) return;
  if (action == GLFW_RELEASE) {
    self.held_.erase(name);
    return;
  }
  self.held_.insert(name);
  if (name == "Shift" || name == "Ctrl" || kAsCharacters.find(name) != std::string_view::npos) return;
  self.keys_.push_back({name, (mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_CONTROL) != 0, action == GLFW_REPEAT});
}

void Window::on_character(GLFWwindow* w, unsigned codepoint) {
  notice(w);
  auto& self = *static_cast<Window*>(glfwGetWindowUserPointer(w));
  if (codepoint < 128 && kAsCharacters.find(static_cast<char>(codepoint)) != std::string_view::npos)
    self.keys_.push_back({std::string(1, static_cast<char>(codepoint))});
}

void Window::on_drop(GLFWwindow* w, int count, const char** paths) {
  notice(w);
  auto& self = *static_cast<Window*>(glfwGetWindowUserPointer(w));
  self.drops_.assign(paths, paths + count);
}

}  // namespace gbl
