#include "renderer/options/presets_sources.h"

namespace gbl {
namespace {

Camera camera_at(glm::dvec3 position, double yaw, double pitch, double fov, double near, double far) {
  return {position, orientation_from_yaw_pitch(yaw, pitch), fov, 0, near, far};
}

// What the fixed twins have in common: the background is skipped, light is summed in half floats and shown by the
// sRGB curve, and nothing is switched on by id.
void fix_common(Settings& s) {
  s.background.skip = BackgroundSkip::depth;
  s.accumulation.format = AccumulationFormat::rgba16f;
  s.colour = Colour::srgb;
  s.mistakes.clear();
}

void fix_volumes(Settings& s) {
  s.lights.cull = LightCull::flip_safe;
  s.lights.volume.fit = VolumeFit::circumscribed;
  s.lights.volume.clip = VolumeClip::none;
}

}  // namespace

// nclgl tutorial 15: constructor (targets, lights), FillBuffers, DrawPointLights, CombineBuffers.
Settings nclgl() {
  Settings s;
  s.scene = "builtin:terrain";
  s.camera = camera_at({2056, 500, 4112}, 0, 0, 45, 1, 10000);
  s.lights.count = 64;
  s.lights.method = LightMethod::volumes;
  s.lights.cull = LightCull::flip;
  s.lights.volume = {VolumeLevel::l2, VolumeFit::inscribed, VolumeClip::planes, VolumeDepth::none};
  s.attenuation = Attenuation::linear;
  s.shading = {ShadingModel::blinn_phong, 33, 0.33};
  s.ambient = 0.2;
  s.background = {BackgroundFill::grey, glm::dvec3(0.2), BackgroundSkip::none};
  s.colour = Colour::as_tutorial;
  s.layout = Layout::nclgl;
  s.normal.encoding = NormalEncoding::xyz8;
  s.depth.format = DepthFormat::d24;
  s.position.reconstruct = PositionReconstruct::inverse_viewproj_varying;
  s.accumulation = {AccumulationFormat::rgba8, AccumulationTargets::split};
  s.mistakes = {Mistake::tbn_precedence, Mistake::specular_ungated, Mistake::blend_on_in_fill};
  return s;
}

Settings nclgl_fixed() {
  Settings s = nclgl();
  fix_common(s);
  fix_volumes(s);
  s.position.reconstruct = PositionReconstruct::view_ray;
  return s;
}

// Tutorial 9: steps 3 (first pass), 7-16 (second pass), 20 (formats). It prints no falloff: ours is declared.
Settings stereo() {
  Settings s;
  s.scene = "builtin:room";
  s.camera = camera_at({2.6, 1.65, 2.75}, 33, -8, 55, 0.05, 50);
  s.lights.source = LightSource::scene;
  s.lights.method = LightMethod::fullscreen;
  s.lights.cull = LightCull::front;
  s.attenuation = Attenuation::windowed;
  s.shading.model = ShadingModel::ggx;
  s.shadows = Shadows::all;         // step 7: an array of maps, an array of cubes, both compared by the sampler
  s.reflections = Reflections::on;  // steps 34-43: planar and cube reflections, and refraction
  s.height_map = HeightMap::on;     // step 4: parallax occlusion mapping, and no depth is written
  s.parallax.depth = ParallaxDepth::flat;
  s.ambient = 0.3;
  s.background = {BackgroundFill::black, glm::dvec3(0.2), BackgroundSkip::none};
  s.layout = Layout::stereo;
  s.normal.encoding = NormalEncoding::stereo16f;
  s.depth.format = DepthFormat::d32f;
  s.position.reconstruct = PositionReconstruct::inverse_viewproj;
  s.accumulation = {AccumulationFormat::r11g11b10f, AccumulationTargets::one};
  return s;
}

Settings stereo_fixed() {
  Settings s = stereo();
  fix_common(s);
  s.normal.encoding = NormalEncoding::oct16;
  s.position.reconstruct = PositionReconstruct::view_ray;
  s.parallax.depth = ParallaxDepth::displaced;
  return s;
}

// De Vries 2014, LearnOpenGL, "Deferred Shading": the first lighting pass is Lambert without any falloff.
Settings learnopengl_a() {
  Settings s;
  s.scene = "builtin:grid";
  s.camera = camera_at({0, 0, 5}, 0, 0, 45, 0.1, 100);
  s.size = {800, 600};
  s.lights.count = 32;
  s.lights.method = LightMethod::fullscreen;
  s.lights.cull = LightCull::front;
  s.attenuation = Attenuation::none;
  s.range.kind = RangeKind::none;
  s.shading = {ShadingModel::lambert, 16, 0.5};
  s.ambient = 0.1;
  s.background = {BackgroundFill::black, glm::dvec3(0.2), BackgroundSkip::none};
  s.normal_map = NormalMap::off;
  s.colour = Colour::as_tutorial;
  s.layout = Layout::learnopengl;
  s.normal.encoding = NormalEncoding::xyz16f;
  s.position.source = PositionSource::world16f;
  s.depth.format = DepthFormat::d24;
  s.accumulation = {AccumulationFormat::rgba8, AccumulationTargets::one};
  s.lights.markers = LightMarkers::on;
  s.mistakes = {Mistake::forward_without_depth};  // its cubes are drawn before the depth blit is explained
  return s;
}

Settings learnopengl_b() {
  Settings s = learnopengl_a();
  s.lights.method = LightMethod::fullscreen_radius;
  s.attenuation = Attenuation::quadratic;
  s.range = {RangeKind::threshold, 5.0 / 256};
  s.shading.model = ShadingModel::blinn_phong;
  s.mistakes.clear();
  return s;
}

Settings learnopengl() {
  Settings s = learnopengl_b();
  s.lights.method = LightMethod::volumes;
  s.lights.cull = LightCull::front;
  s.lights.volume = {VolumeLevel::l2, VolumeFit::inscribed, VolumeClip::planes, VolumeDepth::none};
  s.mistakes = {Mistake::volume_without_distance_test};
  return s;
}

Settings learnopengl_fixed() {
  Settings s = learnopengl();
  fix_common(s);
  s.lights.volume.fit = VolumeFit::circumscribed;
  s.lights.volume.clip = VolumeClip::none;
  s.range.kind = RangeKind::windowed;
  s.position.source = PositionSource::view16f;
  return s;
}

// Tutorial 08-2: geometry shaders, lighting shaders, and the stencil test between them.
Settings objectid() {
  Settings s;
  s.scene = "builtin:spheres";
  s.camera = camera_at({6.8, 8.2, 8.2}, 28, -31, 45, 0.1, 300);
  s.lights.source = LightSource::scene;
  s.lights.spot = LightSpot::cos_power;
  s.lights.method = LightMethod::fullscreen;
  s.lights.cull = LightCull::front;
  s.attenuation = Attenuation::inverse_linear;
  s.range.kind = RangeKind::none;
  s.shading.model = ShadingModel::phong;
  s.ambient = 0.1;
  s.background = {BackgroundFill::colour, {0.1, 0.2, 0.7}, BackgroundSkip::stencil};
  s.normal_map = NormalMap::off;
  s.colour = Colour::as_tutorial;
  s.layout = Layout::objectid;
  s.normal.encoding = NormalEncoding::xyz32f;
  s.position.source = PositionSource::world32f;
  s.depth.format = DepthFormat::d24;
  s.accumulation = {AccumulationFormat::rgba8, AccumulationTargets::one};
  s.mistakes = {Mistake::nonuniform_scale_normal, Mistake::specular_ungated};
  return s;
}

Settings objectid_fixed() {
  Settings s = objectid();
  fix_common(s);
  s.background.skip = BackgroundSkip::stencil;  // no mistake: it stays
  s.range.kind = RangeKind::windowed;
  return s;
}

// Engine blog, parts 28 (reprinted), 30 and 31: outputs.fs, geomainpass.fs, geopointlight.vs.
Settings viewspace() {
  Settings s;
  s.scene = "builtin:grove";
  s.camera = camera_at({0.2, 1.7, 6.4}, 4, 1, 50, 0.1, 400);
  s.lights.source = LightSource::scene;
  s.lights.method = LightMethod::disc;
  s.lights.cull = LightCull::front;
  s.attenuation = Attenuation::ramp;
  s.range = {RangeKind::threshold, 5.0 / 256};
  s.ambient = 0.3;
  s.background = {BackgroundFill::sky, glm::dvec3(0.2), BackgroundSkip::alpha};
  s.colour = Colour::as_tutorial;
  s.layout = Layout::viewspace;
  s.normal = {NormalEncoding::xyz8, NormalSpace::view};
  s.position.source = PositionSource::view_scaled;
  s.depth.format = DepthFormat::d24;
  s.tangents = Tangents::matrix_columns;
  // #3, lsRenderShadowMapsForPointLight, and three cascades of the sun.
  s.shadows = Shadows::all;
  s.shadow.cull = ShadowCull::front;
  s.shadow.bias = s.shadow.slope_bias = 0;
  s.shadow.filter = ShadowFilter::none;
  s.shadow.point = ShadowPoint::brute_force;
  s.shadow.reach = ShadowReach::near_one;
  s.accumulation = {AccumulationFormat::rgba8, AccumulationTargets::one};
  s.mistakes = {Mistake::interpolated_not_normalised, Mistake::decode_not_normalised, Mistake::range_shortcut,
                Mistake::cube_lookat_up};
  return s;
}

Settings viewspace_fixed() {
  Settings s = viewspace();
  fix_common(s);
  s.background.skip = BackgroundSkip::alpha;  // no mistake where the targets are cleared
  s.lights.method = LightMethod::quads;
  s.position.source = PositionSource::view32f;
  s.tangents = Tangents::vertex;
  s.shadow = {};
  return s;
}

}  // namespace gbl
