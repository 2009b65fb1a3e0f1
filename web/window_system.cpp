// A page: the browser says when a frame is due, and how large it is.
#include "app/window_system.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <cmath>
#include <cstdio>
#include <emscripten.h>
#include <emscripten/html5.h>
#include <exception>

namespace gbl {
namespace {

std::function<bool()> g_step;

EM_BOOL resized(int, const EmscriptenUiEvent*, void* window) {
  fit_monitor(static_cast<GLFWwindow*>(window));
  return EM_TRUE;
}

}  // namespace

void ask_for_context(gl::Api) {}
void name_lost_displays() {}
bool wait_for_events(double) { return true; }

// What ends the program on a desktop ends the page: said on it, and the last picture stays.
static void frame() {
  try {
    if (!g_step()) emscripten_cancel_main_loop();
    EM_ASM({ document.body.dataset.frames = 1 + Number(document.body.dataset.frames || 0); });
  } catch (const std::exception& e) {
    std::fprintf(stderr, "gbufferlab: %s\n", e.what());
    emscripten_cancel_main_loop();
  }
}

void each_frame(const std::function<bool()>& step) {
  g_step = step;
  emscripten_set_main_loop(frame, 0, 1);
}

// Emscripten's GLFW counts the other way.
void turn_wheel(GLFWwindow* window) {
  glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) { ImGui_ImplGlfw_ScrollCallback(w, -x, -y); });
}

// clang-format off
EM_JS(void, gbl_download, (const char* file), {
  const path = UTF8ToString(file), link = document.createElement('a');
  FS.ignorePermissions = true;  // its files are written for their owner alone
  link.href = URL.createObjectURL(new Blob([FS.readFile(path)]));
  FS.ignorePermissions = false;
  link.download = path.split('/').pop();
  document.body.dataset.saved = link.download;
  link.click();
});
// clang-format on

void hand_over(const std::string& file) { gbl_download(file.c_str()); }

std::string printed_name(int key, int) {
  if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) return std::string(1, static_cast<char>('a' + key - GLFW_KEY_A));
  return key > GLFW_KEY_SPACE && key < 127 ? std::string(1, static_cast<char>(key)) : "";
}

float content_scale_of(GLFWwindow*) {
  return static_cast<float>(std::round(emscripten_get_device_pixel_ratio() * 4) / 4);
}

// As large as the page is.
void fit_monitor(GLFWwindow* window) {
  double width = 0, height = 0;
  emscripten_get_element_css_size("#canvas", &width, &height);
  if (width > 0 && height > 0) glfwSetWindowSize(window, static_cast<int>(width), static_cast<int>(height));
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
