#include <algorithm>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/file_opening.h"
#include "renderer/base/size_text.h"
#include "renderer/gbuffer/layout_file.h"
#include "renderer/opening/exposure_meter.h"
#include "renderer/opening/scene_look.h"
#include "renderer/options/camera_text.h"
#include "renderer/options/presets.h"
#include "renderer/options/settings_json.h"
#include "renderer/scenes/rig.h"

namespace gbl {
namespace {

void apply_size(Settings& s, const std::string& text) {
  const std::optional<glm::ivec2> size = size_of(text);
  if (!size)
    throw Error(ExitCode::bad_input, "--size", fmt::format("'{}' is not a size", text), "write WxH, e.g. 1280x720");
  apply_patch(s, {{"size", OptionList{size->x, size->y}}}, "--size");
}

}  // namespace

void apply_typed(Settings& s, const std::string& assignment) {
  apply_assignment(s, assignment);
  if (assignment.starts_with("layout-file=")) allow_layout_file(s.layout_file);
}

Setup setup_of(const Arguments& a, const LoadProgress* progress) {
  Setup setup{preset(a.preset.value_or("start")).make(), nullptr};
  Settings& s = setup.settings;
  if (a.state) s = read_state(*a.state);
  if (a.scene) {
    setup.scene = open_scene(*a.scene, progress);
    apply_scene(s, *a.scene, *setup.scene);
    if (!a.preset && !a.state) apply_drawing(s, *a.scene);
  }
  if (a.camera) apply_camera(s, *a.camera, "--camera");
  if (a.lights) {
    apply_patch(s, {{"lights.count", *a.lights}}, "--lights");
    option("lights.count").implies(s);
  }
  if (a.rig) {
    rig_lights(*a.rig);  // refused here, with its place, rather than at the first frame
    apply_patch(s, {{"lights.rig", *a.rig}, {"lights.source", "rig"}}, "--rig");
  }
  if (a.layout_file) s.layout_file = name_layout_file(*a.layout_file);
  if (a.seed) s.lights.seed = *a.seed;
  if (a.size) apply_size(s, *a.size);
  if (a.time) apply_patch(s, {{"time_s", *a.time}}, "--time");
  // A file's exposure is metered from its own camera with its own lights: with others it is metered anew.
  if (setup.scene && is_file(s.scene) && !a.state && (a.camera || a.lights || a.rig)) meter(s, *setup.scene);
  for (const std::string& assignment : a.set) apply_typed(s, assignment);
  if (s.scene != a.scene) setup.scene.reset();
  return setup;
}

Given given_of(const Arguments& a) {
  Given given;
  Settings s;
  const auto give = [&](const char* path) { given.explicitly.push_back({path, option(path).get(s)}); };
  if (a.state) {
    const Settings state = read_state(*a.state);
    for (const Option& o : options())
      if (o.group != Group::view) given.state.push_back({o.path, o.get(state)});
  }
  if (a.preset) given.explicitly.push_back({"preset", *a.preset});
  if (a.scene) given.explicitly.push_back({"scene", *a.scene});
  if (a.camera) {
    apply_camera(s, *a.camera, "--camera");
    for (const char* path : {"camera.position", "camera.orientation", "camera.orthographic-height"}) give(path);
    if (std::count(a.camera->begin(), a.camera->end(), ':') == 2) give("camera.fov"), give("camera.aspect");
  }
  if (a.lights) given.explicitly.push_back({"lights", *a.lights});
  if (a.rig) {
    rig_lights(*a.rig);
    apply_patch(s, {{"lights.rig", *a.rig}, {"lights.source", "rig"}}, "--rig");
    give("lights.rig"), give("lights.source");
  }
  if (a.layout_file) s.layout_file = name_layout_file(*a.layout_file), give("layout-file");
  if (a.seed) s.lights.seed = *a.seed, give("lights.seed");
  if (a.size) given.explicitly.push_back({"size", *a.size});
  if (a.time) apply_patch(s, {{"time_s", *a.time}}, "--time"), give("time_s");
  for (const std::string& assignment : a.set) {
    apply_typed(s, assignment);
    give(assignment.substr(0, assignment.find('=')).c_str());
  }
  return given;
}

FeatureSet without_of(const Arguments& a) { return parse_features(a.without); }

gl::Api api_of(const Arguments& a) {
  if (a.gl == "core") return gl::Api::core;
  if (a.gl == "es3") return gl::Api::es3;
  throw Error(ExitCode::bad_input, "--gl", fmt::format("'{}' is no kind of OpenGL", a.gl),
              "choose core (3.3) or es3 (GLES 3.0, what a browser has)");
}

}  // namespace gbl
