// A page: the browser says when a frame is due, and how large it is.
#include "app/window_system.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <cmath>
#include <emscripten.h>
#include <emscripten/html5.h>

#include "renderer/options/settings_json.h"

namespace gbl {
namespace {

GLFWwindow* g_window = nullptr;  // the page has one

EM_BOOL resized(int, const EmscriptenUiEvent*, void* window) {
  fit_monitor(static_cast<GLFWwindow*>(window));
  return EM_TRUE;
}

}  // namespace

void ask_for_context(gl::Api) {}
void name_lost_displays() {}
bool wait_for_events(double) { return false; }  // events have their callbacks, between two frames

// What page.js does for the program (makeLab's argument).
// clang-format off
EM_JS(void, gbl_download, (const char* file), { Module['download'](UTF8ToString(file)); });
EM_JS(void, gbl_copy, (const char* text), { Module['copy'](UTF8ToString(text)); });
EM_JS(void, gbl_address, (const char* state, const char* lesson), { Module['showInAddress'](UTF8ToString(state), UTF8ToString(lesson)); });
EM_JS(void, gbl_words, (const char* words), { Module['tell'](UTF8ToString(words)); });
EM_JS(int, gbl_less_motion, (), { return matchMedia('(prefers-reduced-motion: reduce)').matches; });
// clang-format on

// Emscripten's GLFW counts a wheel the other way and has no clipboard.
void adjust_imgui(GLFWwindow* window) {
  glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) { ImGui_ImplGlfw_ScrollCallback(w, -x, -y); });
  ImGui::GetIO().SetClipboardTextFn = [](void*, const char* text) { gbl_copy(text); };
}

void hand_over(const std::string& file) { gbl_download(file.c_str()); }
bool wants_less_motion() { return gbl_less_motion() != 0; }
void show_in_address(const Settings& s, const std::string& lesson_place) {
  gbl_address(settings_link(s).c_str(), lesson_place.c_str());
}
void say_in_words(const std::string& words) { gbl_words(words.c_str()); }

std::string printed_name(int key, int) {
  if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) return std::string(1, static_cast<char>('a' + key - GLFW_KEY_A));
  return key > GLFW_KEY_SPACE && key < 127 ? std::string(1, static_cast<char>(key)) : "";
}

float content_scale_of(GLFWwindow*) {
  return static_cast<float>(std::round(emscripten_get_device_pixel_ratio() * 4) / 4);
}

// As large as the page is, in the monitor's own pixels.
void fit_monitor(GLFWwindow* window) {
  g_window = window;
  double width = 0, height = 0;
  emscripten_get_element_css_size("#canvas", &width, &height);
  const double scale = emscripten_get_device_pixel_ratio();
  if (width > 0 && height > 0)
    emscripten_set_canvas_size(static_cast<int>(std::lround(width * scale)),
                               static_cast<int>(std::lround(height * scale)));
  emscripten_set_resize_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, window, EM_FALSE, resized);
}

bool FullScreen::on(GLFWwindow*) const {
  EmscriptenFullscreenChangeEvent now;
  return emscripten_get_fullscreen_status(&now) == EMSCRIPTEN_RESULT_SUCCESS && now.isFullscreen;
}
void FullScreen::toggle(GLFWwindow* window) {
  if (on(window))
    emscripten_exit_fullscreen();
  else
    emscripten_request_fullscreen("#canvas", EM_TRUE);
}

}  // namespace gbl

// A file that was given to the page, as if dropped on a window.
extern "C" EMSCRIPTEN_KEEPALIVE void page_open(const char* file) {
  if (!gbl::g_window) return;
  const GLFWdropfun drop = glfwSetDropCallback(gbl::g_window, nullptr);
  glfwSetDropCallback(gbl::g_window, drop);
  drop(gbl::g_window, 1, &file);
}
