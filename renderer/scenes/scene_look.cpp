#include "renderer/scenes/scene_look.h"

#include <algorithm>
#include <cmath>

#include "renderer/options/settings_json.h"
#include "renderer/scenes/builtin_scenes.h"

namespace gbl {
namespace {

constexpr std::string_view kPrefix = "builtin:";
bool is_builtin(std::string_view name) { return name.substr(0, kPrefix.size()) == kPrefix; }

// glTF materials are metallic-roughness: shown by the model they are made for, in the layout that loses nothing.
constexpr const char* kGltfLook = R"({"layout": "float32", "shading.model": "ggx", "shading.exponent": "from-roughness",
  "attenuation": "windowed", "background.fill": "colour", "lights.count": 64, "view.volumes": "off", "lights.cull": "front",
  "lights.volume.clip": "none"})";

double brightest(const Light& l) { return std::max({l.colour.x, l.colour.y, l.colour.z}); }

// The strongest light's radiance on white, seen from a quarter of the scene's diagonal, is shown as this: room for the
// other lights above it.
constexpr double kShownStrongest = 0.6;

double exposure_of(const Scene& scene) {
  const double typical = std::max(1e-6, glm::length(scene.bounds.extent()) / 4);
  double strongest = 0;
  for (const Light& l : scene.lights)
    strongest = std::max(strongest, brightest(l) / (l.kind == LightKind::directional ? 1 : typical * typical));
  return strongest > 0 ? std::clamp(kShownStrongest / strongest, 1e-6, 1e6) : 1;
}

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
  scene.warnings.emplace_back("it has no lights: a key and a fill light were added");
}

void complete_file_scene(Scene& scene) {
  if (scene.lights.empty()) add_studio_lights(scene);
  scene.exposure = exposure_of(scene);
  // A light without a range ends where its radiance on white falls to 1/255 after exposure.
  for (Light& l : scene.lights)
    if (l.kind != LightKind::directional && l.range >= kEndless)
      l.range = std::sqrt(255 * scene.exposure * brightest(l));
  const glm::dvec3 margin = 0.1 * scene.bounds.extent() + 1e-3;
  scene.light_box = LightBox{scene.bounds.min - margin, scene.bounds.max + margin};
}

const char* look_of(std::string_view name) {
  if (!is_builtin(name)) return kGltfLook;
  for (const BuiltinScene& row : builtin_scenes())
    if (name.substr(kPrefix.size()) == row.id) return row.look;
  return "{}";
}

}  // namespace

std::shared_ptr<const Scene> open_scene(std::string_view name, const LoadProgress* progress) {
  if (is_builtin(name)) return std::make_shared<const Scene>(load_scene(name));
  auto scene = std::make_shared<Scene>(load_gltf(std::filesystem::path(name), progress));
  complete_file_scene(*scene);
  return scene;
}

void reset_look(Settings& s) {
  const Settings plain;
  for (const Option& o : options()) {
    const std::string_view path = o.path;
    const bool kept = path == "scene" || path == "size" || path == "time_s";
    if ((o.group == Group::truth && !kept) || path == "layout") o.set(s, o.get(plain), o);
  }
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
    s.ambient = std::min(0.2 / scene.exposure, 100.0);
    s.background.colour = glm::dvec3(std::min(0.03 / scene.exposure, 1e4));
  }
  apply_patch(s, parse_patch(look_of(name), name), name);
}

}  // namespace gbl
