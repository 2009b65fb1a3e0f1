// The page: the window of the desktop, in a browser. ?preset=, ?scene=, ?lights=, ?lesson=, ?pitfall= say what it starts with.
#include <cstdio>
#include <cstdlib>
#include <emscripten.h>
#include <fmt/format.h>

#include "app/commands.h"
#include "renderer/base/number.h"

// clang-format off
EM_JS(char*, gbl_asked, (const char* name), {
  const value = new URLSearchParams(location.search).get(UTF8ToString(name)) || '';
  const bytes = lengthBytesUTF8(value) + 1, to = _malloc(bytes);
  stringToUTF8(value, to, bytes);
  return to;
});
// clang-format on

namespace gbl {

bool display_present() { return true; }

namespace {

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

Arguments arguments_of_address() {
  Arguments a;
  a.command = "view", a.gl = "es3", a.fresh = true;
  a.preset = if_asked("preset"), a.scene = if_asked("scene");
  a.lesson = asked("lesson"), a.pitfall = asked("pitfall");
  if (const auto lights = if_asked("lights")) {
    const auto count = whole_decimal(*lights);
    if (!count || *count < 0 || *count > kMaxLights)
      throw Error(ExitCode::bad_input, "?lights", fmt::format("'{}' is no number of lights", *lights),
                  "give 0 to 16384");
    a.lights = static_cast<int>(*count);
  }
  return a;
}

}  // namespace
}  // namespace gbl

int main() {
  try {
    return static_cast<int>(gbl::run_view(gbl::arguments_of_address()));
  } catch (const std::exception& e) {
    std::fprintf(stderr, "gbufferlab: %s\n", e.what());
    return 1;
  }
}
