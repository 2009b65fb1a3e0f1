#pragma once
// The window without a window: an ImGui context, frames drawn into nothing, no back-end and no GL.
#include <algorithm>
#include <imgui.h>
#include <string>
#include <vector>

#include "renderer/frame/frame_lights.h"
#include "renderer/light/lights.h"
#include "renderer/options/presets.h"
#include "ui/keys.h"
#include "ui/panels/options.h"
#include "ui/state.h"

namespace gbl::ui {

// A desk with the window on it: settings, a small scene, and frames drawn into nothing.
class Desk {
 public:
  explicit Desk(ImVec2 display = {1600, 900}, bool present = false, const Settings& loaded = preset("start").make())
      : settings(loaded), ui(loaded, present) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = display;
    io.KeyMap[ImGuiKey_Space] = ' ';
    Ui::set_up_style();
    unsigned char* pixels;
    int width, height;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    scene.bounds = {{0, 0, 0}, {4112, 319, 4112}};
    report.size = settings.size;
    report.passes = {{"geometry", 12.3}, {"lighting", 1248.7}, {"combine", 33.2}, {"display", 11.9}, {"count", {}}};
    report.time_source = "software-rasteriser";
    report.pairs = PairCounts{12345678, 11234567, 10034567};
    report.draw_calls = 16401;
    report.drawn.lights.method = LightMethod::fullscreen_radius;  // the longest texts that auto can give
    report.method_reason = "the lights reach so many pixels that leaving any out costs more";
    frame();
  }
  ~Desk() { ImGui::DestroyContext(); }

  const Requests& frame(const std::vector<KeyEvent>& keys = {}) {
    const std::vector<Light> lights = lights_of(settings, scene);
    Input input{.scene = scene, .lights = lights, .features = features, .report = report};
    input.seconds = seconds;
    input.held = held;
    input.still = still;
    input.chart = chart;
    input.stability = stability;
    input.advisor = advisor;
    input.path = path;
    input.message = message, input.message_is_error = message_is_error;
    input.images = images, input.stats = stats;
    input.account = account, input.numbers = numbers;
    input.probe = PixelProbe{.pixel = probed_pixel, .stored = stored};
    const auto probed = [&](ProbeField field, glm::vec3 value) {
      input.probe->values[static_cast<size_t>(field)] = {value, 0};
    };
    probed(ProbeField::surface, glm::vec3(1)), probed(ProbeField::roughness, glm::vec3(0.5f));
    probed(ProbeField::normal, {0, 1, 0}), probed(ProbeField::range, glm::vec3(1234.5f));
    probed(ProbeField::lights, glm::vec3(5));
    ImGui::GetIO().DeltaTime = 1.0f / 60;
    ImGui::NewFrame();
    requests = ui.draw(settings, input, keys);
    ImGui::Render();
    return requests;
  }
  const Requests& press(const std::string& key, bool shift = false, bool ctrl = false) {
    return frame({KeyEvent{key, shift, ctrl, false}});
  }
  const Requests& point(ImVec2 at, bool left = false, bool right = false) {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = at;
    io.MouseDown[0] = left;
    io.MouseDown[1] = right;
    return frame();
  }
  void click(ImVec2 at) {
    for (const bool down : {false, true, false}) point(at, down);
    frame();
  }
  // A tap of Enter that is over before the frame: an event and no key that is down.
  void type(const char* text) {
    ImGui::GetIO().AddInputCharactersUTF8(text);
    frame();
    press("Enter");
    frame();
  }
  int visible() const { return static_cast<int>(std::count(requests.visible.begin(), requests.visible.end(), true)); }

  Settings settings;
  Ui ui;
  Scene scene;
  FrameReport report;
  FeatureSet features;  // nothing beyond the core path
  Requests requests;
  const ChartInput* chart = nullptr;
  const StabilityInput* stability = nullptr;
  const AdvisorInput* advisor = nullptr;
  const PathInput* path = nullptr;
  std::string message;
  bool message_is_error = false;
  std::array<ViewImage, kViewCount> images;
  std::array<const ViewStats*, kViewCount> stats{};
  const PixelAccount* account = nullptr;
  const PixelNumbers* numbers = nullptr;
  glm::ivec2 probed_pixel{123, 456};
  std::vector<StoredTexel> stored;  // of the probe
  bool still = false;
  double seconds = 0;
  std::vector<std::string> held;
};

}  // namespace gbl::ui
