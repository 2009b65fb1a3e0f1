#include "renderer/frame/resolved_frame.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/frame/estimate.h"
#include "renderer/frame/frame_lights.h"
#include "renderer/frame/method_choice.h"
#include "renderer/frame/resolve.h"
#include "renderer/gbuffer/position_source.h"
#include "renderer/scenes/rig.h"

namespace gbl {
namespace {

// Of so many lights per pixel a loop is as quick one by one as four at once, of which some are dark. (hall, llvmpipe.)
constexpr double kFewLights = 3;
constexpr double kFewWithSpecialOnes = 10;  // they are read from three more texels each

constexpr size_t kKept = 4;  // A and B of a comparison, the picture and what is measured beside it

bool plain_point(const Light& l) { return l.kind == LightKind::point && l.coefficients == glm::dvec3(0); }

bool has_transparent(const Scene& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& m) { return m.alpha_mode == AlphaMode::blend; });
}

void take_attachments(ResolvedFrame& f) {
  const Settings& s = f.settings;
  f.attachments = attachments(s);
  f.gbuffer_bytes_per_pixel = bytes_per_pixel(f.attachments, Pass::geometry);
  f.accumulation_bytes_per_pixel = bytes_per_pixel(f.attachments, Pass::lighting);
  f.shading = shading_of(s.lights.method);
  f.split = find(f.attachments, Stores::diffuse_light) != nullptr;
  f.folds_light = folds_light(s);
  f.light_sum_is_begun = sum_begins_in_geometry(s);
  f.normal_in_material = normal_in_material(s);
  f.stencil = needs_stencil(s);
  f.lighting_tests_depth = lighting_tests_depth(s);
  f.lighting_has_depth = f.lighting_tests_depth || f.stencil;
  f.multisampled = s.antialias == Antialias::msaa_resolved && f.shading != Shading::forward;
  f.volume_depth_step = volume_depth_step(s);
}

void take_camera(ResolvedFrame& f) {
  const Settings& s = f.settings;
  f.aspect = double(s.size.x) / s.size.y;
  f.depth_runs = depth_runs(s.depth.format);
  f.clip_from_relative = clip_from_relative(s.camera, f.aspect, f.depth_runs);
}

// lights: all there are. One that is drawn alone has the shadow that it has among the others.
// camera: as it was asked for, whose planes do not follow the scene.
void take_shadows(ResolvedFrame& f, const Scene& scene, const std::vector<Light>& lights, const Camera& camera) {
  const Settings& s = f.settings;
  if (s.shadows == Shadows::off) return;
  const auto texels = [](ShadowMapSize size) { return 256 << static_cast<int>(size); };
  const bool once = s.shadow.update == ShadowUpdate::once && s.time_s != 0;
  Settings at_first = s;
  at_first.time_s = 0;
  f.shadows = plan_shadows(once ? all_lights_of(at_first, scene) : lights, camera, f.aspect, scene.bounds,
                           {.map_texels = texels(s.shadow.map_size),
                            .cascades = s.shadow.cascades,
                            .most_lights = s.shadow.max_lights,
                            .suns_only = s.shadows == Shadows::sun,
                            .stable = s.shadow.stable == ShadowStable::on,
                            .near_one = s.shadow.reach == ShadowReach::near_one,
                            .up_is_always_y = f.mistaken(Mistake::cube_lookat_up)});
  if (const int only = s.lights.only; only >= 0) keep_only(f.shadows, static_cast<size_t>(only));
  if (f.shadows.without > 0)
    f.choices.push_back(
        fmt::format("{} of {} lights have no shadow map: shadow.max-lights is {}, and all maps fit into "
                    "{} texels a side",
                    f.shadows.without, f.shadows.without + f.shadows.with, s.shadow.max_lights, kMostShadowTexels));
}

void take_mirrors(ResolvedFrame& f, const Scene& scene) {
  const Settings& s = f.settings;
  if (s.reflections == Reflections::off || s.reflect.method == ReflectMethod::none) return;
  std::vector<Mirror> all = mirrors_of(scene);
  if (all.empty()) f.choices.emplace_back("nothing is mirrored: no surface of the scene is smooth enough");
  if (f.multisampled && !all.empty()) {
    f.choices.emplace_back(
        "nothing is mirrored: with antialias=msaa-resolved no depth is left to draw mirrors against");
    return;
  }
  for (Mirror& m : all) m.flat = m.flat && s.reflect.method == ReflectMethod::planar;
  // From behind, a plane shows nothing.
  for (Mirror& m : all)
    if (m.two_sided) m.plane = facing(m.plane, s.camera);
  std::erase_if(all, [&](const Mirror& m) { return m.flat && !faces(m.plane, s.camera); });
  // A mirror without its picture is a dull surface, but glass is a hole.
  std::stable_partition(all.begin(), all.end(), [](const Mirror& m) { return m.clear; });
  if (all.size() > kMostMirrors) {
    f.choices.push_back(fmt::format("{} of {} mirrors show nothing: a frame draws {}", all.size() - kMostMirrors,
                                    all.size(), kMostMirrors));
    all.resize(kMostMirrors);
  }
  f.mirrors = std::move(all);
}

// Each has a mesh of its own: how finely it is cut depends on where it stands.
void take_tessellated(ResolvedFrame& f, const Scene& scene) {
  const Settings& s = f.settings;
  const int asked_level = s.tessellation.level;
  if (s.height_map == HeightMap::off) return;
  std::vector<int> uses(scene.meshes.size());
  for (const Instance& i : scene.instances) ++uses[static_cast<size_t>(i.mesh)];
  int shared = 0, deep = 0;
  long long patches = 0;
  for (size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& in = scene.instances[i];
    if (!has_heights(scene.materials[static_cast<size_t>(in.material)])) continue;
    ++deep;
    if (s.tessellation.mode == TessellationMode::off) continue;
    if (uses[static_cast<size_t>(in.mesh)] != 1) {
      ++shared;
      continue;
    }
    f.tessellated.push_back(static_cast<int>(i));
    patches += static_cast<long long>(scene.meshes[static_cast<size_t>(in.mesh)].indices.size() / 3);
  }
  int& level = f.settings.tessellation.level;
  while (level > 1 && patches * tessellated_triangles(level) > kMostTessellated) --level;
  if (level < asked_level)
    f.choices.push_back(fmt::format("tessellation.level={} instead of {}: {} triangles would become more than {}",
                                    level, asked_level, patches, kMostTessellated));
  if (deep == 0) f.choices.emplace_back("all surfaces stay flat: no material of the scene has a height map");
  if (shared > 0)
    f.choices.push_back(fmt::format("{} objects are not tessellated: they share their meshes with others", shared));
}

Settings without_view(Settings s) {
  s.view = {};
  return s;
}

void take_only(ResolvedFrame& f) {
  const int only = f.settings.lights.only;
  if (only < 0) return;
  if (only < f.light_total) {
    f.lights = {f.lights[static_cast<size_t>(only)]};
    return;
  }
  f.lights.clear();
  f.choices.push_back(
      fmt::format("no light is drawn: lights.only is {}, and there are {} lights", only, f.light_total));
}

void take_special_lights(ResolvedFrame& f) {
  for (uint32_t i = 0; i < f.lights.size(); ++i) {
    const bool has_shadow = !f.shadows.first_map.empty() && f.shadows.first_map[i] >= 0;
    if (has_shadow || !plain_point(f.lights[i])) f.special_lights.push_back(i);
  }
}

}  // namespace

ResolvedFrame resolve_frame(const Settings& s, const Scene& scene, FeatureSet features) {
  Resolved resolved = resolve(s, scene);
  choose_depth(resolved, scene, features);
  ResolvedFrame f{.settings = without_view(std::move(resolved.settings)), .choices = std::move(resolved.notes)};
  f.lights = all_lights_of(s, scene);
  f.light_total = static_cast<int>(f.lights.size());
  const std::vector<Light> all = f.lights;
  take_only(f);
  f.light_kinds = !std::all_of(f.lights.begin(), f.lights.end(), plain_point);
  MethodChoice choice = choose_method(f.settings, f.lights, features);
  f.settings.lights.method = choice.method;
  f.method_reason = std::move(choice.reason);
  const LightsInView view = lights_in_view(f.settings, f.lights);
  const LightWork work = work_of(f.settings.lights.method, view);
  f.light_work = work.units;
  take_attachments(f);
  take_camera(f);
  take_shadows(f, scene, all, s.camera);
  take_special_lights(f);
  f.many_lights = work.tested > (f.special_lights.empty() ? kFewLights : kFewWithSpecialOnes) * view.pixels;
  take_mirrors(f, scene);
  take_tessellated(f, scene);
  f.light_sum_scale = light_sum_scale(f.settings.exposure);
  f.transparent_pass = has_transparent(scene) || f.settings.lights.markers == LightMarkers::on;
  return f;
}

std::shared_ptr<const ResolvedFrame> Resolver::get(const Settings& s, const std::shared_ptr<const Scene>& scene,
                                                   FeatureSet features) {
  const Settings asked = without_view(s);
  const long long stamp = s.lights.source == LightSource::rig ? rig_stamp(s.lights.rig) : 0;
  const auto same = [&](const Entry& e) {
    return e.scene.lock() == scene && e.features == features && e.rig_stamp == stamp && e.settings == asked;
  };
  const auto found = std::find_if(entries_.begin(), entries_.end(), same);
  if (found != entries_.end()) {
    std::rotate(entries_.begin(), found, found + 1);
    return entries_.front().frame;
  }
  auto frame = std::make_shared<const ResolvedFrame>(resolve_frame(asked, *scene, features));
  ++resolved_;
  entries_.insert(entries_.begin(), {asked, scene, features, stamp, frame});
  if (entries_.size() > kKept) entries_.pop_back();
  return frame;
}

}  // namespace gbl
