#include "renderer/presets.h"

#include <fmt/format.h>
#include <vector>

#include "renderer/error.h"

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
  s.lights.method = LightMethod::volumes;
  s.lights.cull = LightCull::flip;
  s.lights.volume = {VolumeLevel::l2, VolumeFit::circumscribed, VolumeClip::planes, VolumeDepth::none};
  s.shading.specular = 0.04;  // a dielectric's reflectance: the lobe comes from roughness and is normalised
  s.view.volumes = VolumeOverlay::picked;
  s.view.pick = 41;  // a distant light, in the upper middle of the picture
  return s;
}

// Source 0 with its mistakes mended and nothing else changed: its camera, its attachments' bits, its constants.
// Mended: normal-map precedence, background lit, grey-cleared light target, RGBA8 sums, highlights on faces turned
// away, no sRGB, one light's NaN, inverse matrix as a varying, near-plane cut, inscribed mesh.
Settings nclgl_fixed() {
  Settings s = start();
  s.camera.position = {2056, 500, 4112};
  s.camera.orientation = orientation_from_yaw_pitch(0, 0);
  s.layout = Layout::nclgl;
  s.normal.encoding = NormalEncoding::xyz8;
  s.depth.format = DepthFormat::d24;
  s.position.reconstruct = PositionReconstruct::view_ray;
  s.shading.exponent = 33;
  s.shading.specular = 0.33;
  s.ambient = 0.2;
  s.background.fill = BackgroundFill::grey;
  s.lights.cull = LightCull::flip_safe;
  s.lights.volume.clip = VolumeClip::none;
  s.accumulation = {AccumulationFormat::rgba16f, AccumulationTargets::split};
  s.view.volumes = VolumeOverlay::off;
  return s;
}

constexpr Preset kPresets[] = {
    {"start", "Start", "the first screen: terrain, 64 lights as volumes, 12 bytes per pixel", start},
    {"nclgl-fixed", "nclgl, mended", "nclgl tutorial 15 with its mistakes mended: RGBA8 colour, RGBA8 normal, D24",
     nclgl_fixed},
};

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
