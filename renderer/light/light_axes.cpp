#include "renderer/light/light_axes.h"

#include "renderer/rows/value_table.h"

namespace gbl {
namespace {

// clang-format off
constexpr ValueRow kLightSource[] = {
  {.value = at(LightSource::scene), .id = "scene", .label = "the scene's own", .help = "the lights that the scene brings"},
  {.value = at(LightSource::generated), .id = "generated", .label = "generated", .help = "N lights placed by the scene's generator from a seed, at constant mean overlap"},
  {.value = at(LightSource::rig), .id = "rig", .label = "a lighting rig", .help = "the lights of the file named by lights.rig"},
};
constexpr ValueRow kLightSpot[] = {
  {.value = at(LightSpot::cone), .id = "cone", .label = "cone", .help = "spot lights end smoothly between an inner and an outer angle"},
  {.value = at(LightSpot::cos_power), .id = "cos-power", .label = "power of the cosine", .help = "no edge: cos^n of the angle off the axis, n such that a twentieth is left at the outer angle", .source = "tutorial 08-2, ProcessSpotLights"},
};
constexpr ValueRow kLightMarkers[] = {
  {.value = at(LightMarkers::off), .id = "off", .label = "off", .help = "lights are not drawn"},
  {.value = at(LightMarkers::on), .id = "on", .label = "cubes", .help = "a small cube in its colour at each point and spot light, drawn forward after lighting", .source = "de Vries 2014, LearnOpenGL, Deferred Shading"},
};
constexpr ValueRow kShadows[] = {
  {.value = at(Shadows::off), .id = "off", .label = "off", .help = "light passes through everything, as in the tutorials' first steps"},
  {.value = at(Shadows::sun), .id = "sun", .label = "of the sun", .help = "what stands between a surface and a directional light hides it; blended surfaces hide nothing"},
  {.value = at(Shadows::all), .id = "all", .label = "of all lights", .help = "the same of point and spot lights, too"},
};
constexpr ValueRow kReflections[] = {
  {.value = at(Reflections::off), .id = "off", .label = "off", .help = "surfaces reflect lights alone"},
  {.value = at(Reflections::on), .id = "on", .label = "once", .help = "smooth surfaces (roughness up to 0.2, no roughness texture) mirror the scene, lit and shadowed, but not its mirrors; blended surfaces are not seen in them"},
};
constexpr ValueRow kReflectMethod[] = {
  {.value = at(ReflectMethod::none), .id = "none", .label = "none", .help = "nothing is mirrored"},
  {.value = at(ReflectMethod::planar), .id = "planar", .label = "planar, else cube", .help = "a flat mirror shows the scene from behind its plane, to the pixel; others read a cube", .cost = "a frame more for each flat mirror", .source = "tutorial 9, steps 40 and 41"},
  {.value = at(ReflectMethod::cube), .id = "cube", .label = "cube", .help = "six pictures from the object's middle, read by direction alone: right for what is far away", .cost = "six square frames for each mirror, drawn again when lights or settings change", .source = "tutorial 9, steps 37, 42 and 43"},
};
constexpr ValueRow kReflectParallax[] = {
  {.value = at(ReflectParallax::none), .id = "none", .label = "none", .help = "a cube is read by direction, as if all it shows were infinitely far away"},
  {.value = at(ReflectParallax::box), .id = "box", .label = "the scene's box", .help = "directions are bent to where the ray leaves the scene's box: right for the walls of a room, wrong for what stands in it", .source = "Lagarde and Zanuttini 2012, Local Image-based Lighting With Parallax-corrected Cubemaps"},
};
constexpr ValueRow kReflectSize[] = {
  {.value = at(ReflectSize::s64), .id = "64", .label = "64", .help = "texels to a side of each of a cube's pictures"},
  {.value = at(ReflectSize::s128), .id = "128", .label = "128", .help = "texels to a side of each of a cube's pictures"},
  {.value = at(ReflectSize::s256), .id = "256", .label = "256", .help = "texels to a side of each of a cube's pictures"},
  {.value = at(ReflectSize::s512), .id = "512", .label = "512", .help = "texels to a side of each of a cube's pictures"},
};
constexpr ValueRow kShadowMapSize[] = {
  {.value = at(ShadowMapSize::s256), .id = "256", .label = "256", .help = "texels to a side of each map", .cost = "64 K texels a map"},
  {.value = at(ShadowMapSize::s512), .id = "512", .label = "512", .help = "texels to a side of each map", .cost = "256 K texels a map"},
  {.value = at(ShadowMapSize::s1024), .id = "1024", .label = "1024", .help = "texels to a side of each map", .cost = "1 M texels a map"},
  {.value = at(ShadowMapSize::s2048), .id = "2048", .label = "2048", .help = "texels to a side of each map", .cost = "4 M texels a map"},
  {.value = at(ShadowMapSize::s4096), .id = "4096", .label = "4096", .help = "texels to a side of each map", .cost = "16 M texels a map"},
};
constexpr ValueRow kShadowFormat[] = {
  {.value = at(ShadowFormat::d16), .id = "d16", .label = "D16", .help = "65536 depths: of a light's perspective most of them lie just before it", .cost = "2 B a texel"},
  {.value = at(ShadowFormat::d24), .id = "d24", .label = "D24", .help = "what most programs take", .cost = "4 B a texel"},
  {.value = at(ShadowFormat::d32f), .id = "d32f", .label = "D32F", .help = "float depth", .cost = "4 B a texel"},
};
constexpr ValueRow kShadowCull[] = {
  {.value = at(ShadowCull::none), .id = "none", .label = "both faces drawn", .help = "whatever is in the way hides the light, whichever side it turns to it"},
  {.value = at(ShadowCull::back), .id = "back", .label = "front faces drawn", .help = "an open surface hides nothing from behind"},
  {.value = at(ShadowCull::front), .id = "front", .label = "back faces drawn", .help = "no acne on what is lit, but open surfaces hide nothing and light leaks where a wall is thin", .source = "engine blog, shadow passes"},
};
constexpr ValueRow kShadowFilter[] = {
  {.value = at(ShadowFilter::none), .id = "none", .label = "nearest texel", .help = "lit or not: the edge has steps"},
  {.value = at(ShadowFilter::bilinear), .id = "2x2", .label = "2 x 2, weighted", .help = "the four texels around the point, by its place among them: what a hardware comparison gives", .source = "Reeves et al. 1987, Rendering Antialiased Shadows with Depth Maps"},
  {.value = at(ShadowFilter::pcf3), .id = "3x3", .label = "3 x 3", .help = "nine comparisons averaged: softer, and wrong for as many texels more", .source = "Reeves et al. 1987, Rendering Antialiased Shadows with Depth Maps"},
};
constexpr ValueRow kShadowStable[] = {
  {.value = at(ShadowStable::off), .id = "off", .label = "fitted to the view", .help = "the least square around what is seen: fine, and it creeps over the surfaces with every step of the camera"},
  {.value = at(ShadowStable::on), .id = "on", .label = "stable", .help = "around a sphere, moved by whole texels: edges stay where they are while the camera moves", .cost = "up to half the texels lie beside the view", .source = "Valient 2007, Stable Rendering of Cascaded Shadow Maps"},
};
constexpr ValueRow kShadowPoint[] = {
  {.value = at(ShadowPoint::axis), .id = "axis", .label = "by the longest axis", .help = "of six maps the one that a cube map would read"},
  {.value = at(ShadowPoint::brute_force), .id = "brute-force", .label = "by trying all six", .help = "the first of six maps that the point falls into", .cost = "up to six matrices a pixel and light", .source = "engine blog, part 30"},
};
constexpr ValueRow kShadowReach[] = {
  {.value = at(ShadowReach::fitted), .id = "fitted", .label = "fitted", .help = "from a thousandth of the light's range to its end, or to the end of the scene"},
  {.value = at(ShadowReach::near_one), .id = "near-1", .label = "from 1 to 1.5 ranges", .help = "what is nearer to the light than one unit hides nothing", .source = "engine blog, part 30"},
};
constexpr ValueRow kShadowUpdate[] = {
  {.value = at(ShadowUpdate::changed), .id = "changed", .label = "when they change", .help = "a map is drawn once and again when its light, or of a sun what is seen, has moved: the bits of each-frame"},
  {.value = at(ShadowUpdate::each_frame), .id = "each-frame", .label = "each frame", .help = "all maps, whether they changed or not"},
  {.value = at(ShadowUpdate::once), .id = "once", .label = "once", .help = "as lights stood at time 0: shadows stay behind when they move"},
};
constexpr ValueRow kAttenuation[] = {
  {.value = at(Attenuation::none), .id = "none", .label = "none", .help = "full strength up to the range, then nothing"},
  {.value = at(Attenuation::linear), .id = "linear", .label = "linear 1 - d/r", .help = "falls in a straight line to 0 at the range; a visible kink at the rim", .source = "nclgl tutorial 15, pointlightfragment.glsl line 27"},
  {.value = at(Attenuation::quadratic), .id = "quadratic", .label = "1/(1 + 0.7 d + 1.8 d2)", .help = "never reaches 0: cut off at the range", .source = "de Vries 2014, LearnOpenGL, Deferred Shading"},
  {.value = at(Attenuation::ramp), .id = "ramp", .label = "1/max(1, 0.2 + 0.4 x + 0.4 x2)", .help = "x = 4 d/r: full near the light, then a kink, cut off at the range", .source = "engine blog, parts 30 and 31"},
  {.value = at(Attenuation::inverse_linear), .id = "inverse-linear", .label = "1/(1 + 9 d/r)", .help = "falls to a tenth, cut off at the range", .source = "tutorial 08-2, point lights"},
  {.value = at(Attenuation::windowed), .id = "windowed", .label = "inverse square, windowed", .help = "(1 - (d/r)^4)^2 / d^2: physical near the light, smoothly 0 at the range", .source = "Karis 2013, Real Shading in Unreal Engine 4"},
  {.value = at(Attenuation::gltf), .id = "gltf", .label = "inverse square, as glTF", .help = "(1 - (d/r)^4) / d^2, and 1/d^2 without a range: what glTF files mean; a kink at the range", .source = "Khronos, KHR_lights_punctual, Range Property"},
};
constexpr ValueRow kRangeKind[] = {
  {.value = at(RangeKind::source), .id = "source", .label = "as the source says", .help = "the light's own range; nothing is lit at or beyond it"},
  {.value = at(RangeKind::threshold), .id = "threshold", .label = "where it gets faint", .help = "a light ends where its falloff leaves range.threshold of its brightest channel's 1: a visible edge", .source = "de Vries 2014, LearnOpenGL, Deferred Shading: 5/256"},
  {.value = at(RangeKind::windowed), .id = "windowed", .label = "windowed", .help = "as the source says, and the falloff times (1 - (d/r)^4)^2: smoothly 0 at the range", .source = "Karis 2013, Real Shading in Unreal Engine 4"},
  {.value = at(RangeKind::none), .id = "none", .label = "endless", .help = "lights never end: every pixel is in every light, and culling saves nothing", .cost = "all pairs", .source = "tutorial 08-2, ProcessPointLights"},
};
constexpr ValueRow kLightCull[] = {
  {.value = at(LightCull::flip), .id = "flip", .label = "flip", .help = "back faces when the camera is nearer than the range, else front faces (as source 0)", .source = "nclgl tutorial 15, renderer.cpp lines 228-234", .pitfall = Pitfall::near_plane_cut},
  {.value = at(LightCull::back), .id = "back", .label = "back", .help = "front faces only: nothing is left to draw once the camera is inside", .pitfall = Pitfall::backface_cull_inside},
  {.value = at(LightCull::none), .id = "none", .label = "none", .help = "both faces: every light counts twice when seen from outside", .cost = "2 x pairs", .pitfall = Pitfall::no_culling_doubles},
  {.value = at(LightCull::front), .id = "front", .label = "front", .help = "back faces only: right inside and outside, while no plane clips them"},
  {.value = at(LightCull::flip_safe), .id = "flip-safe", .label = "flip-safe", .help = "as flip, but inside means nearer than the mesh's radius plus the near plane's corner"},
};
constexpr ValueRow kVolumeLevel[] = {
  {.value = at(VolumeLevel::l0), .id = "0", .label = "0 (20 faces)", .help = "the icosahedron itself", .cost = "20 triangles"},
  {.value = at(VolumeLevel::l1), .id = "1", .label = "1 (80 faces)", .help = "each face split in four once", .cost = "80 triangles"},
  {.value = at(VolumeLevel::l2), .id = "2", .label = "2 (320 faces)", .help = "split twice", .cost = "320 triangles"},
  {.value = at(VolumeLevel::l3), .id = "3", .label = "3 (1280 faces)", .help = "split three times", .cost = "1280 triangles"},
  {.value = at(VolumeLevel::l4), .id = "4", .label = "4 (5120 faces)", .help = "split four times", .cost = "5120 triangles"},
};
constexpr ValueRow kVolumeFit[] = {
  {.value = at(VolumeFit::inscribed), .id = "inscribed", .label = "inscribed", .help = "vertices on the sphere: the faces cut into it and notches appear at the rim", .pitfall = Pitfall::inscribed_mesh},
  {.value = at(VolumeFit::circumscribed), .id = "circumscribed", .label = "circumscribed", .help = "scaled by 1/inradius: the mesh contains the sphere", .cost = "up to 24 % more pairs at level 0"},
};
constexpr ValueRow kVolumeClip[] = {
  {.value = at(VolumeClip::none), .id = "none", .label = "not clipped", .help = "vertices are put at mid-depth, so near and far planes cut nothing"},
  {.value = at(VolumeClip::planes), .id = "planes", .label = "near and far clip", .help = "the planes cut the mesh as in the sources: whole lights can vanish", .pitfall = Pitfall::near_plane_cut},
};
constexpr ValueRow kVolumeDepth[] = {
  {.value = at(VolumeDepth::none), .id = "none", .label = "no depth test", .help = "every pixel under the volume is shaded, near or far"},
  {.value = at(VolumeDepth::less_equal), .id = "less-equal", .label = "front faces before the surface", .help = "leaves out surfaces in front of the volume; needs cull back, and with it loses the light that the camera is inside", .cost = "a copy of the depth", .pitfall = Pitfall::backface_cull_inside, .needs = Feature::depth_clamp},
  {.value = at(VolumeDepth::greater_equal), .id = "greater-equal", .label = "back faces behind the surface", .help = "leaves out surfaces behind the volume; needs cull front, and is right inside and outside", .cost = "a copy of the depth", .needs = Feature::depth_clamp},
};
// clang-format on

}  // namespace

GBL_ROWS(LightSource, kLightSource)
GBL_ROWS(LightSpot, kLightSpot)
GBL_ROWS(LightMarkers, kLightMarkers)
GBL_ROWS(Shadows, kShadows)
GBL_ROWS(Reflections, kReflections)
GBL_ROWS(ReflectMethod, kReflectMethod)
GBL_ROWS(ReflectSize, kReflectSize)
GBL_ROWS(ReflectParallax, kReflectParallax)
GBL_ROWS(ShadowMapSize, kShadowMapSize)
GBL_ROWS(ShadowFormat, kShadowFormat)
GBL_ROWS(ShadowCull, kShadowCull)
GBL_ROWS(ShadowFilter, kShadowFilter)
GBL_ROWS(ShadowStable, kShadowStable)
GBL_ROWS(ShadowPoint, kShadowPoint)
GBL_ROWS(ShadowReach, kShadowReach)
GBL_ROWS(ShadowUpdate, kShadowUpdate)
GBL_ROWS(Attenuation, kAttenuation)
GBL_ROWS(RangeKind, kRangeKind)
GBL_ROWS(LightCull, kLightCull)
GBL_ROWS(VolumeLevel, kVolumeLevel)
GBL_ROWS(VolumeFit, kVolumeFit)
GBL_ROWS(VolumeClip, kVolumeClip)
GBL_ROWS(VolumeDepth, kVolumeDepth)

}  // namespace gbl
