#include "renderer/opening/scene_look.h"

#include <algorithm>

#include "renderer/opening/exposure_meter.h"
#include "renderer/options/presets.h"
#include "renderer/options/settings_json.h"
#include "renderer/scenes/builtin_scenes.h"
#include "renderer/truth/visible_triangles.h"

namespace gbl {
namespace {

constexpr std::string_view kPrefix = "builtin:";
bool is_builtin(std::string_view name) { return name.substr(0, kPrefix.size()) == kPrefix; }

// A scene without a row of its own is a file. Its materials are metallic-roughness: shown by the model that they are
// made for. Nobody has chosen how it is drawn, so the lab chooses.
constexpr BuiltinScene kFile{
    .look = R"({"shading.model": "ggx", "shading.exponent": "from-roughness", "attenuation": "gltf",
                "background.fill": "colour", "view.volumes": "off"})",
    .drawing = R"({"layout": "auto", "normal.encoding": "oct14", "depth.format": "auto", "lights.method": "auto",
                   "lights.cull": "front", "lights.volume.clip": "none"})"};

// A model without lights is seen as in a studio: a key light over the camera's left shoulder, a fill from its right.
void add_studio_lights(Scene& scene) {
  const glm::dmat3 world_from_view(glm::mat3_cast(scene.camera.orientation));
  const auto add = [&](glm::dvec3 direction_in_view, double strength) {
    Light l;
    l.kind = LightKind::directional;
    l.direction = glm::normalize(world_from_view * direction_in_view);
    l.colour = glm::dvec3(strength);
    scene.lights.push_back(l);
  };
  add({0.5, -0.7, -0.6}, 1);
  add({-0.8, -0.1, -0.6}, 0.25);
  scene.studio_lights = true;
}

const BuiltinScene& row_of(std::string_view name) {
  if (is_builtin(name))
    for (const BuiltinScene& row : builtin_scenes())
      if (name.substr(kPrefix.size()) == row.id) return row;
  return kFile;
}

void take_group(Settings& to, Group group, const Settings& from) {
  for (const Option& o : options())
    if (o.group == group) o.set(to, o.get(from), o);
}

// What looks may have changed, back to the defaults: so that no scene keeps the look of the one before.
void reset_look(Settings& s) {
  const Settings plain;
  for (const Option& o : options()) {
    const std::string_view path = o.path;
    const bool kept = path == "scene" || path == "size" || path == "time_s";
    if (o.group == Group::truth && !kept) o.set(s, o.get(plain), o);
  }
}

// Of a file that shows nothing from its own camera, why.
void say_if_unseen(const Settings& s, Scene& scene) {
  const bool blends = std::any_of(scene.materials.begin(), scene.materials.end(),
                                  [](const Material& m) { return m.alpha_mode == AlphaMode::blend; });
  if (scene.instances.empty() || blends || sees_surface(s, scene, false)) return;  // what is blended is not looked for
  scene.warnings.emplace_back(
      sees_surface(s, scene, true)
          ? "all triangles that its camera sees face away from it, and no material is double-sided"
          : "its camera sees none of its surfaces: move it, or give --camera");
}

// A file's lights are metered on its surfaces from its own camera.
void complete_file_scene(Scene& scene) {
  if (scene.lights.empty()) add_studio_lights(scene);
  const glm::dvec3 margin = 0.1 * scene.bounds.extent() + 1e-3;
  scene.light_box = LightBox{scene.bounds.min - margin, scene.bounds.max + margin};
  Settings s;
  apply_scene(s, "model", scene);
  s.size = {160, 90};
  say_if_unseen(s, scene);
  scene.exposure = metered_exposure(s, scene).value_or(1);
}

Settings drawn_as_it_comes(std::string_view scene) {
  Settings s = preset("start").make();
  apply_drawing(s, scene);
  return s;
}

}  // namespace

bool is_file(std::string_view scene) { return !is_builtin(scene); }

std::shared_ptr<const Scene> open_scene(std::string_view name, const LoadProgress* progress) {
  if (is_builtin(name)) return std::make_shared<const Scene>(load_scene(name));
  auto scene = std::make_shared<Scene>(load_gltf(std::filesystem::path(name), progress));
  complete_file_scene(*scene);
  return scene;
}

void apply_scene(Settings& s, std::string_view name, const Scene& scene) {
  s.scene = name;
  s.camera = scene.camera;
  s.exposure = scene.exposure;
  const Settings plain;
  s.lights.source = scene.lights.empty() ? LightSource::generated : LightSource::scene;
  s.lights.count = plain.lights.count, s.lights.seed = plain.lights.seed;
  s.lights.range_scale = 1, s.lights.only = -1, s.lights.first = -1;
  s.view.pick = 0, s.view.object = 0;  // numbers of another scene mean nothing here
  if (!is_builtin(name)) {
    // As displayed: a fifth of ambient light before a dark backdrop, whatever the exposure.
    s.exposure = 1, s.ambient = 0.2, s.background.colour = glm::dvec3(0.03);
    set_exposure(s, scene.exposure);
  }
  apply_patch(s, parse_patch(row_of(name).look, name), name);
}

std::vector<std::string> notes_of(const Scene& scene, LightSource lights) {
  std::vector<std::string> notes = scene.warnings;
  if (scene.studio_lights && lights == LightSource::scene)
    notes.emplace_back("it has no lights: a key and a fill light were added");
  return notes;
}

void apply_drawing(Settings& s, std::string_view name) {
  apply_patch(s, parse_patch(row_of(name).drawing, name), name);
}

Settings moved_to(const Settings& from, std::string_view name, const Scene& scene) {
  Settings s = from, chosen = drawn_as_it_comes(from.scene);
  take_group(chosen, Group::truth, from), take_group(chosen, Group::view, from);
  const bool nothing_chosen = chosen == from;
  reset_look(s);
  apply_scene(s, name, scene);
  if (nothing_chosen) take_group(s, Group::method, drawn_as_it_comes(name));
  return s;
}

}  // namespace gbl
