#include "renderer/options/presets.h"

#include <fmt/format.h>
#include <vector>

#include "renderer/base/error.h"
#include "renderer/options/presets_sources.h"

namespace gbl {
namespace {

// The first screen. The camera stands inside the volumes of lights 37 and 38: cull `back` loses them.
Settings start() {
  Settings s;
  s.scene = "builtin:terrain";
  s.camera.position = {2470, 340, 3320};
  s.camera.orientation = orientation_from_yaw_pitch(7, -23);
  s.camera.fov = 45;
  s.camera.near = 1;
  s.camera.far = 10000;
  s.lights.count = 64;
  s.lights.seed = 16, s.exposure = 1.8;  // the terrain's look: lights that meet before the camera have other hues
  s.lights.method = LightMethod::volumes;
  s.lights.cull = LightCull::flip;
  s.lights.volume = {VolumeLevel::l2, VolumeFit::circumscribed, VolumeClip::planes, VolumeDepth::none};
  s.shading.specular = 0.04;  // a dielectric's reflectance: the lobe comes from roughness and is normalised
  s.view.volumes = VolumeOverlay::picked;
  s.view.pick = 41;  // a distant light, in the upper middle of the picture
  return s;
}

// The smallest layout whose error a class cannot see: light is summed within one run of a shader and stored once, in
// half floats.
Settings compact() {
  Settings s = start();
  s.lights.seed = 1, s.exposure = 1;  // as what docs/findings.md says of these two was measured
  s.layout = Layout::compact;
  s.depth.format = DepthFormat::d32f_reversed;  // the same bytes, and positions a thousand times closer far away
  s.normal.encoding = NormalEncoding::oct14;
  s.lights.method = LightMethod::auto_;
  s.accumulation.targets = AccumulationTargets::folded;
  s.lights.cull = LightCull::front;
  s.lights.volume.clip = VolumeClip::none;
  s.view.volumes = VolumeOverlay::off;
  return s;
}

// The smallest layout within half a display step.
Settings exact() {
  Settings s = compact();
  s.layout = Layout::exact;
  s.normal.encoding = NormalEncoding::oct16_precise;
  s.accumulation.format = AccumulationFormat::rgba32f;
  return s;
}

// clang-format off
constexpr Preset kPresets[] = {
    {"start", "Start", "the first screen: terrain, 64 lights as volumes, 12 bytes per pixel", start},
    {"nclgl", "nclgl", "nclgl tutorial 15 as printed: RGBA8 colour and normal, D24, 64 sphere volumes, RGBA8 light", nclgl},
    {"nclgl-fixed", "nclgl, fixed", "the same targets and lights, without its mistakes", nclgl_fixed},
    {"stereo", "stereo", "tutorial 9 as printed: stereographic normals, an accumulation target that begins with ambient, shadows, mirrors and glass", stereo},
    {"stereo-fixed", "stereo, fixed", "the same, with normals that have a code for every direction", stereo_fixed},
    {"learnopengl-a", "learnopengl, stage a", "LearnOpenGL, Deferred Shading, first pass: 32 lights on every pixel, Lambert, no falloff", learnopengl_a},
    {"learnopengl-b", "learnopengl, stage b", "LearnOpenGL, Deferred Shading: falloff, and a radius where it reaches 5/256", learnopengl_b},
    {"learnopengl", "learnopengl, stage c", "LearnOpenGL, Deferred Shading: a sphere per light, back faces only", learnopengl},
    {"learnopengl-fixed", "learnopengl, fixed", "stage c without its mistakes: windowed ranges, positions from the camera", learnopengl_fixed},
    {"objectid", "objectid", "tutorial 08-2 as printed: 56 bytes per pixel with object ids, all lights full screen; no shadows there either", objectid},
    {"objectid-fixed", "objectid, fixed", "the same targets, without its mistakes", objectid_fixed},
    {"viewspace", "viewspace", "engine blog, parts 30 and 31, as printed: scaled view positions, lights as discs, three maps of the sun and six of each lamp", viewspace},
    {"viewspace-fixed", "viewspace, fixed", "the same layout with raw positions and exact screen bounds", viewspace_fixed},
    {"compact", "compact", "12 or 16 bytes per pixel, for an error that a class cannot see", compact},
    {"exact", "exact", "the fewest bytes for half a display step", exact},
};
// clang-format on

}  // namespace

std::span<const Preset> presets() { return kPresets; }

const Preset& preset(std::string_view id) {
  std::vector<std::string_view> known;
  for (const Preset& p : kPresets) {
    if (p.id == id) return p;
    known.push_back(p.id);
  }
  throw Error(ExitCode::bad_input, "--preset", fmt::format("unknown preset '{}'", id), suggest(id, known));
}

const Preset* preset_of(const Settings& s) {
  for (const Preset& p : kPresets) {
    Settings other = p.make();
    other.size = s.size;
    other.time_s = s.time_s;
    other.view = s.view;
    if (other == s) return &p;
  }
  return nullptr;
}

}  // namespace gbl
