#include <algorithm>
#include <fmt/format.h>
#include <sstream>

#include "app/commands.h"
#include "app/file_opening.h"
#include "renderer/base/number.h"
#include "renderer/base/size_text.h"
#include "renderer/opening/exposure_meter.h"
#include "renderer/opening/scene_look.h"
#include "renderer/options/presets.h"
#include "renderer/options/settings_json.h"
#include "renderer/scenes/rig.h"

namespace gbl {
namespace {

// "1,2.5,-3" -> numbers; anything else is an Error.
std::vector<double> numbers(const std::string& text, const char* where, const char* form) {
  std::vector<double> out;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::optional<double> n = decimal(part);
    if (!n)
      throw Error(ExitCode::bad_input, where, fmt::format("'{}' is not a number", part), fmt::format("write {}", form));
    out.push_back(*n);
  }
  return out;
}

void apply_camera(Settings& s, const std::string& text) {
  constexpr const char* kForm = "x,y,z:yaw,pitch[:fov]";
  std::vector<std::string> parts;
  std::istringstream split(text);
  for (std::string part; std::getline(split, part, ':');) parts.push_back(part);
  const auto bad = [&] {
    return Error(ExitCode::bad_input, "--camera", fmt::format("'{}' is not a camera", text),
                 fmt::format("write {}", kForm));
  };
  if (parts.size() < 2 || parts.size() > 3) throw bad();
  const auto place = numbers(parts[0], "--camera", kForm), turn = numbers(parts[1], "--camera", kForm);
  if (place.size() != 3 || turn.size() != 2) throw bad();
  apply_patch(s, {{"camera.position", OptionList(place.begin(), place.end())}}, "--camera");
  s.camera.orientation = orientation_from_yaw_pitch(turn[0], turn[1]);
  s.camera.orthographic_height = 0;
  if (parts.size() < 3) return;
  const auto fov = numbers(parts[2], "--camera", kForm);
  if (fov.size() != 1) throw bad();
  apply_patch(s, {{"camera.fov", fov[0]}, {"camera.aspect", 0}}, "--camera");
}

void apply_size(Settings& s, const std::string& text) {
  const std::optional<glm::ivec2> size = size_of(text);
  if (!size)
    throw Error(ExitCode::bad_input, "--size", fmt::format("'{}' is not a size", text), "write WxH, e.g. 1280x720");
  apply_patch(s, {{"size", OptionList{size->x, size->y}}}, "--size");
}

}  // namespace

Setup setup_of(const Arguments& a, const LoadProgress* progress) {
  Setup setup{preset(a.preset.value_or("start")).make(), nullptr};
  Settings& s = setup.settings;
  if (a.state) s = read_state(*a.state);
  if (a.scene) {
    setup.scene = open_scene(*a.scene, progress);
    apply_scene(s, *a.scene, *setup.scene);
    if (!a.preset && !a.state) apply_drawing(s, *a.scene);
  }
  if (a.camera) apply_camera(s, *a.camera);
  if (a.lights) {
    apply_patch(s, {{"lights.count", *a.lights}}, "--lights");
    option("lights.count").implies(s);
  }
  if (a.rig) {
    rig_lights(*a.rig);  // refused here, with its place, rather than at the first frame
    apply_patch(s, {{"lights.rig", *a.rig}, {"lights.source", "rig"}}, "--rig");
  }
  if (a.seed) s.lights.seed = *a.seed;
  if (a.size) apply_size(s, *a.size);
  if (a.time) apply_patch(s, {{"time_s", *a.time}}, "--time");
  // A file's exposure is metered from its own camera with its own lights: with others it is metered anew.
  if (setup.scene && is_file(s.scene) && !a.state && (a.camera || a.lights || a.rig)) meter(s, *setup.scene);
  for (const std::string& assignment : a.set) apply_assignment(s, assignment);
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
    apply_camera(s, *a.camera);
    for (const char* path : {"camera.position", "camera.orientation", "camera.orthographic-height"}) give(path);
    if (std::count(a.camera->begin(), a.camera->end(), ':') == 2) give("camera.fov"), give("camera.aspect");
  }
  if (a.lights) given.explicitly.push_back({"lights", *a.lights});
  if (a.rig) {
    rig_lights(*a.rig);
    apply_patch(s, {{"lights.rig", *a.rig}, {"lights.source", "rig"}}, "--rig");
    give("lights.rig"), give("lights.source");
  }
  if (a.seed) s.lights.seed = *a.seed, give("lights.seed");
  if (a.size) given.explicitly.push_back({"size", *a.size});
  if (a.time) apply_patch(s, {{"time_s", *a.time}}, "--time"), give("time_s");
  for (const std::string& assignment : a.set) {
    apply_assignment(s, assignment);
    give(assignment.substr(0, assignment.find('=')).c_str());
  }
  return given;
}

FeatureSet without_of(const Arguments& a) { return parse_features(a.without); }

}  // namespace gbl
