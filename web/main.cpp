// The page: the window of the desktop, in a browser. What it starts with stands in its address: ?preset=, ?scene=, ?lights=,
// ?set=PATH=VALUE (repeatable), ?lesson=, ?pitfall=, ?exercise=, ?present, or whole settings behind #, which page.js leaves in a
// file.
#include <cstdio>
#include <cstdlib>
#include <emscripten.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>
#include <vector>

#include "app/lab_window.h"
#include "renderer/base/limits.h"
#include "renderer/base/number.h"
#include "renderer/exercises/exercise.h"
#include "renderer/options/settings_json.h"

// clang-format off
EM_JS(char*, gbl_asked, (const char* name), {
  const value = new URLSearchParams(location.search).getAll(UTF8ToString(name)).join(String.fromCharCode(10));
  const bytes = lengthBytesUTF8(value) + 1, to = _malloc(bytes);
  stringToUTF8(value, to, bytes);
  return to;
});
EM_JS(void, gbl_frame_drawn, (), { Module['frameDrawn'](); });
EM_JS(int, gbl_hidden, (), { return document.hidden; });
// clang-format on

namespace gbl {

bool display_present() { return true; }

namespace {

constexpr const char* kLink = "/link.json";

std::string asked(const char* name) {
  char* text = gbl_asked(name);
  std::string out = text;
  std::free(text);
  return out;
}

std::optional<std::string> if_asked(const char* name) {
  std::string text = asked(name);
  return text.empty() ? std::nullopt : std::optional(std::move(text));
}

// What is asked several times comes as lines.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) out.push_back(line);
  return out;
}

// The first screen.
Arguments plain_arguments() {
  Arguments a;
  a.command = "view", a.gl = "es3", a.fresh = true;
  return a;
}

Arguments arguments_of_address() {
  Arguments a = plain_arguments();
  a.present = !asked("present").empty();
  a.lesson = asked("lesson"), a.pitfall = asked("pitfall");
  if (const auto exercise = if_asked("exercise"); exercise && !std::filesystem::exists(kLink))
    std::ofstream(kLink) << settings_text(state_of(load_exercise(*exercise)));
  if (std::filesystem::exists(kLink)) {  // says everything
    a.state = kLink;
    return a;
  }
  a.preset = if_asked("preset"), a.scene = if_asked("scene");
  if (const auto set = if_asked("set")) a.set = lines_of(*set);
  if (const auto lights = if_asked("lights")) {
    const auto count = whole_decimal(*lights);
    if (!count || *count < 0 || *count > kMaxLights)
      throw Error(ExitCode::bad_input, "?lights", fmt::format("'{}' is no number of lights", *lights),
                  fmt::format("give 0 to {}", kMaxLights));
    a.lights = static_cast<int>(*count);
  }
  return a;
}

std::unique_ptr<LabWindow> g_window;

// What ends the program on a desktop ends the page: said on it, and the last picture stays.
void guarded(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::exception& e) {
    emscripten_cancel_main_loop();
    std::fprintf(stderr, "gbufferlab: %s\n", e.what());
  }
}

// What the address asks for; where that is wrong it is said, and the lab opens as it opens without.
std::unique_ptr<LabWindow> opened() {
  try {
    return std::make_unique<LabWindow>(arguments_of_address());
  } catch (const Error& e) {
    std::fprintf(stderr, "gbufferlab: %s\n", e.what());
    return std::make_unique<LabWindow>(plain_arguments());
  }
}

void frame() {
  if (gbl_hidden()) return;  // some browsers go on asking, once a second
  guarded([] {
    if (!g_window->step()) emscripten_cancel_main_loop();
    gbl_frame_drawn();
  });
}

}  // namespace
}  // namespace gbl

// All of OpenGL made anew, where a browser has lost it.
extern "C" EMSCRIPTEN_KEEPALIVE void page_begin() {
  emscripten_cancel_main_loop();
  gbl::guarded([] {
    gbl::g_window.reset();
    gbl::g_window = gbl::opened();
    emscripten_set_main_loop(gbl::frame, 0, 0);
  });
}

// The pixel that is held, and of how many: "x y width height"; empty: none is.
extern "C" EMSCRIPTEN_KEEPALIVE const char* page_pixel() {
  static std::string text;
  const auto p = gbl::g_window->probed();
  text = p ? fmt::format("{} {} {} {}", p->pixel.x, p->pixel.y, p->size.x, p->size.y) : "";
  return text.c_str();
}

int main() {
  page_begin();
  return 0;
}
