#include "renderer/options/axes.h"

#include <fmt/format.h>
#include <vector>

#include "renderer/base/error.h"

namespace gbl {
namespace {

template <class E>
constexpr int at(E e) {
  return static_cast<int>(e);
}

template <size_t N>
constexpr bool in_order(const ValueRow (&table)[N]) {
  for (size_t i = 0; i < N; ++i)
    if (table[i].value != static_cast<int>(i)) return false;
  return true;
}

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
constexpr ValueRow kAttenuation[] = {
  {.value = at(Attenuation::none), .id = "none", .label = "none", .help = "full strength up to the range, then nothing"},
  {.value = at(Attenuation::linear), .id = "linear", .label = "linear 1 - d/r", .help = "falls in a straight line to 0 at the range; a visible kink at the rim", .source = "nclgl tutorial 15, pointlightfragment.glsl line 27"},
  {.value = at(Attenuation::quadratic), .id = "quadratic", .label = "1/(1 + 0.7 d + 1.8 d2)", .help = "never reaches 0: cut off at the range", .source = "de Vries 2014, LearnOpenGL, Deferred Shading"},
  {.value = at(Attenuation::ramp), .id = "ramp", .label = "1/max(1, 0.2 + 0.4 x + 0.4 x2)", .help = "x = 4 d/r: full near the light, then a kink, cut off at the range", .source = "engine blog, parts 30 and 31"},
  {.value = at(Attenuation::inverse_linear), .id = "inverse-linear", .label = "1/(1 + 9 d/r)", .help = "falls to a tenth, cut off at the range", .source = "tutorial 08-2, point lights"},
  {.value = at(Attenuation::windowed), .id = "windowed", .label = "inverse square, windowed", .help = "(1 - (d/r)^4)^2 / d^2: physical near the light, smoothly 0 at the range", .source = "Karis 2013, Real Shading in Unreal Engine 4"},
};
constexpr ValueRow kRangeKind[] = {
  {.value = at(RangeKind::source), .id = "source", .label = "as the source says", .help = "the light's own range; nothing is lit at or beyond it"},
  {.value = at(RangeKind::threshold), .id = "threshold", .label = "where it gets faint", .help = "a light ends where its falloff leaves range.threshold of its brightest channel's 1: a visible edge", .source = "de Vries 2014, LearnOpenGL, Deferred Shading: 5/256"},
  {.value = at(RangeKind::windowed), .id = "windowed", .label = "windowed", .help = "as the source says, and the falloff times (1 - (d/r)^4)^2: smoothly 0 at the range", .source = "Karis 2013, Real Shading in Unreal Engine 4"},
  {.value = at(RangeKind::none), .id = "none", .label = "endless", .help = "lights never end: every pixel is in every light, and culling saves nothing", .cost = "all pairs", .source = "tutorial 08-2, ProcessPointLights"},
};
constexpr ValueRow kShadingModel[] = {
  {.value = at(ShadingModel::lambert), .id = "lambert", .label = "Lambert", .help = "diffuse only", .source = "Lambert 1760, Photometria"},
  {.value = at(ShadingModel::phong), .id = "phong", .label = "Phong", .help = "highlight about the mirrored light direction", .source = "Phong 1975, Illumination for computer generated pictures"},
  {.value = at(ShadingModel::blinn_phong), .id = "blinn-phong", .label = "Blinn-Phong", .help = "half-vector highlight, only where the surface faces the light", .source = "Blinn 1977, Models of light reflection for computer synthesized pictures"},
  {.value = at(ShadingModel::ggx), .id = "ggx", .label = "GGX", .help = "microfacets from roughness, metals and F0", .source = "Walter et al. 2007, Microfacet models for refraction through rough surfaces"},
};
constexpr ValueRow kBackgroundFill[] = {
  {.value = at(BackgroundFill::black), .id = "black", .label = "black", .help = "0 where no surface is"},
  {.value = at(BackgroundFill::grey), .id = "grey", .label = "grey", .help = "linear 0.2 where no surface is"},
  {.value = at(BackgroundFill::colour), .id = "colour", .label = "colour", .help = "background.colour (linear) where no surface is"},
  {.value = at(BackgroundFill::sky), .id = "sky", .label = "sky", .help = "a blue gradient from horizon to zenith where no surface is"},
};
constexpr ValueRow kNormalMap[] = {
  {.value = at(NormalMap::on), .id = "on", .label = "on", .help = "normal maps bend the shading normal"},
  {.value = at(NormalMap::off), .id = "off", .label = "off", .help = "interpolated vertex normals only"},
};
constexpr ValueRow kAlbedoSource[] = {
  {.value = at(AlbedoSource::textured), .id = "textured", .label = "textured", .help = "the material's own colour"},
  {.value = at(AlbedoSource::white), .id = "white", .label = "white", .help = "every surface white: the lighting alone"},
};
constexpr ValueRow kColour[] = {
  {.value = at(Colour::srgb), .id = "srgb", .label = "sRGB", .help = "textures decoded, display encoded by the sRGB curve", .source = "IEC 61966-2-1:1999"},
  {.value = at(Colour::as_tutorial), .id = "as-tutorial", .label = "as the tutorial", .help = "texels used as if linear and shown unencoded, as the sources print it"},
};
constexpr ValueRow kLayout[] = {
  {.value = at(Layout::albedo_roughness), .id = "albedo-roughness", .label = "albedo + roughness", .help = "one RGBA8: sRGB-coded albedo, roughness", .cost = "4 B/px"},
  {.value = at(Layout::nclgl), .id = "nclgl", .label = "nclgl colour", .help = "one RGBA8: colour as the texture has it, alpha unused", .cost = "4 B/px", .source = "nclgl tutorial 15, bufferFragment.glsl line 22"},
  {.value = at(Layout::stereo), .id = "stereo", .label = "stereo", .help = "the sum already holding ambient and emission, diffuse RGB8, specular colour + roughness", .cost = "8 B/px and the sum", .source = "tutorial 9, steps 3 and 20"},
  {.value = at(Layout::learnopengl), .id = "learnopengl", .label = "learnopengl", .help = "one RGBA8: albedo, specular strength; no roughness", .cost = "4 B/px", .source = "de Vries 2014, LearnOpenGL, Deferred Shading: gAlbedoSpec"},
  {.value = at(Layout::objectid), .id = "objectid", .label = "objectid", .help = "ambient Ka, diffuse Kd, specular Ks in RGBA8, exponent Ns R32F, object id R32UI", .cost = "20 B/px", .source = "tutorial 08-2, GBufferAmbient to GBufferObjectID"},
  {.value = at(Layout::viewspace), .id = "viewspace", .label = "viewspace", .help = "ambient, diffuse, specular + shininess/256, RGBA8 each; exponents in whole steps up to 256", .cost = "12 B/px", .source = "engine blog, part 28 as reprinted with parts 30 and 31: outputs.fs"},
  {.value = at(Layout::compact), .id = "compact", .label = "compact", .help = "RG32UI: normal 28 bits (with oct14), sRGB-coded albedo 26, roughness 10; no metal, emission or occlusion", .cost = "8 B/px, normal included", .source = "the lab's own"},
  {.value = at(Layout::compact_metal), .id = "compact-metal", .label = "compact + metal", .help = "compact, and a R32UI: metal 10 bits and occlusion 10; where a surface shines, emission 24 as displayed, metal 3, occlusion 4", .cost = "12 B/px, normal included", .source = "the lab's own"},
  {.value = at(Layout::exact), .id = "exact", .label = "exact", .help = "RG32UI: base colour 3 x 10 bits sRGB-coded, roughness 14, metal 10, occlusion 10; no emission", .cost = "8 B/px", .source = "the lab's own"},
  {.value = at(Layout::exact_emission), .id = "exact-emission", .label = "exact + emission", .help = "exact, and a R32UI: emission 11 11 10 bits, sRGB-coded as displayed", .cost = "12 B/px", .source = "the lab's own"},
  {.value = at(Layout::float32), .id = "float32", .label = "float, nothing lost", .help = "albedo, roughness, F0, metal, emission and ambient occlusion in floats: the zero-error end", .cost = "48 B/px"},
  {.value = at(Layout::auto_), .id = "auto", .label = "by the scene", .help = "the smallest layout that holds what the scene's materials have, and says what it leaves out", .source = "the lab's own"},
};
constexpr ValueRow kNormalEncoding[] = {
  {.value = at(NormalEncoding::xyz8), .id = "xyz8", .label = "xyz 8+8+8", .help = "n * 0.5 + 0.5 in three 8-bit codes: most codes are no unit vector", .cost = "32 bits (24 used)", .source = "nclgl tutorial 15, bufferFragment.glsl line 23"},
  {.value = at(NormalEncoding::xyz8_raw), .id = "xyz8-raw", .label = "xyz 8+8+8, not biased", .help = "n itself in three 8-bit codes that hold no sign: what is negative becomes 0, and +Z stands for a normal with nothing left", .cost = "32 bits (24 used)", .source = "engine blog, part 30 (mended in part 31)", .pitfall = "negative-normal-clamped"},
  {.value = at(NormalEncoding::xyz10), .id = "xyz10", .label = "xyz 10+10+10", .help = "n * 0.5 + 0.5 in three 10-bit codes of one word", .cost = "32 bits (30 used)"},
  {.value = at(NormalEncoding::xyz16f), .id = "xyz16f", .label = "xyz 16F+16F+16F", .help = "n itself in half floats: fine steps near 0 where they matter least, coarse ones near 1", .cost = "64 bits (48 used)", .source = "de Vries 2014, LearnOpenGL, Deferred Shading"},
  {.value = at(NormalEncoding::xyz32f), .id = "xyz32f", .label = "xyz 32F+32F+32F", .help = "n itself in floats, returned to the last bit: the zero-error end", .cost = "128 bits (96 used)", .source = "tutorial 08-2, GBufferNormal"},
  {.value = at(NormalEncoding::bestfit8), .id = "bestfit8", .label = "best fit 8+8+8", .help = "three 8-bit codes of the length that points nearest to n; the search over 64 lengths costs time", .cost = "32 bits (24 used)", .source = "Kaplanyan 2010, CryENGINE 3: reaching the speed of light"},
  {.value = at(NormalEncoding::stereo16f), .id = "stereo16f", .label = "stereographic 16F+16F", .help = "projected from the -Z pole to a plane: excellent, but no code for the pole itself", .cost = "32 bits", .source = "tutorial 9, step 3 (it says \"stereoscopic\")", .pitfall = "stereographic-pole"},
  {.value = at(NormalEncoding::lambert16), .id = "lambert16", .label = "Lambert equal-area 16+16", .help = "the sphere as a disc whose rim is the -Z pole, two 16-bit codes: sound, but coarse close to that pole", .cost = "32 bits", .source = "Lambert 1772, Entwerfung der Land- und Himmelscharten; Mittring 2009, A bit more deferred"},
  {.value = at(NormalEncoding::spherical16), .id = "spherical16", .label = "spherical 16+16", .help = "azimuth and polar angle in 16-bit codes: azimuths crowd at the poles, and both ways need angles", .cost = "32 bits", .source = "Cigolle et al. 2014, Survey of efficient representations for independent unit vectors"},
  {.value = at(NormalEncoding::oct8), .id = "oct8", .label = "octahedral 8+8", .help = "the sphere unfolded to a square, two 8-bit codes: facets in highlights", .cost = "16 bits", .source = "Cigolle et al. 2014, Survey of efficient representations for independent unit vectors"},
  {.value = at(NormalEncoding::oct10), .id = "oct10", .label = "octahedral 10+10", .help = "the sphere unfolded to a square, two 10-bit codes of one word", .cost = "32 bits (20 used)", .source = "Cigolle et al. 2014, Survey of efficient representations for independent unit vectors"},
  {.value = at(NormalEncoding::oct12), .id = "oct12", .label = "octahedral 12+12", .help = "the sphere unfolded to a square, two 12-bit codes of one word: 8 bits are left for something else", .cost = "32 bits (24 used)", .source = "Cigolle et al. 2014, Survey of efficient representations for independent unit vectors"},
  {.value = at(NormalEncoding::oct14), .id = "oct14", .label = "octahedral 14+14", .help = "the sphere unfolded to a square, two 14-bit codes of one word: 4 bits are left for flags", .cost = "32 bits (28 used)", .source = "Cigolle et al. 2014, Survey of efficient representations for independent unit vectors"},
  {.value = at(NormalEncoding::oct16), .id = "oct16", .label = "octahedral 16+16", .help = "the sphere unfolded to a square, two 16-bit codes", .cost = "32 bits", .source = "Meyer et al. 2010, On floating-point normal vectors; Cigolle et al. 2014, Survey of efficient representations"},
  {.value = at(NormalEncoding::oct16_precise), .id = "oct16-precise", .label = "octahedral 16+16, best of four", .help = "as oct16, but of the four codes around the point the one that points nearest to n", .cost = "32 bits", .source = "Cigolle et al. 2014, Survey of efficient representations for independent unit vectors"},
  {.value = at(NormalEncoding::xy_sqrt), .id = "xy-sqrt", .label = "xy 12+12, z = +sqrt", .help = "x and y in 12-bit codes, z from the unit length: its sign is lost, so what faces -Z is mirrored", .cost = "32 bits (24 used)", .source = "nclgl tutorial 15, section G-Buffers", .pitfall = "xy-only-z-sqrt"},
};
constexpr ValueRow kNormalSpace[] = {
  {.value = at(NormalSpace::world), .id = "world", .label = "world", .help = "normals are stored along the world's axes: the pole -Z of an encoding is a direction that a wall may face"},
  {.value = at(NormalSpace::view), .id = "view", .label = "view", .help = "normals are stored along the camera's axes: the pole -Z faces away and is hardly seen, but at silhouettes z < 0 remains", .source = "engine blog, parts 30 and 31"},
};
constexpr ValueRow kPositionSource[] = {
  {.value = at(PositionSource::depth), .id = "depth", .label = "from depth", .help = "position is recomputed from the depth buffer", .cost = "no attachment"},
  {.value = at(PositionSource::linear32f), .id = "linear32f", .label = "linear depth 32F", .help = "distance along the view axis in a float of its own, whatever the depth buffer holds", .cost = "4 B/px", .source = "tutorial 9, exercise 45, made an attachment"},
  {.value = at(PositionSource::world16f), .id = "world16f", .label = "world 16F", .help = "world position in half floats: rings step 2^-11 of the distance from the origin, and end at 65504", .cost = "8 B/px", .source = "de Vries 2014, LearnOpenGL, Deferred Shading: gPosition"},
  {.value = at(PositionSource::world32f), .id = "world32f", .label = "world 32F", .help = "world position in floats: as exact as floats are this far from the origin", .cost = "16 B/px", .source = "tutorial 08-2, GBufferPosition"},
  {.value = at(PositionSource::view16f), .id = "view16f", .label = "view 16F", .help = "view-space position in half floats: exact near the camera, whatever the origin", .cost = "8 B/px"},
  {.value = at(PositionSource::view32f), .id = "view32f", .label = "view 32F", .help = "view-space position in floats: what the interpolator gave, to the last bit but one", .cost = "16 B/px"},
  {.value = at(PositionSource::view_scaled), .id = "view-scaled", .label = "view / 10^6 + 1/2", .help = "view-space position squeezed into 0..1: a float used as fixed point, 3 cm steps at any distance", .cost = "16 B/px", .source = "engine blog, outputs.fs: posScale"},
};
constexpr ValueRow kPositionReconstruct[] = {
  {.value = at(PositionReconstruct::view_ray), .id = "view-ray", .label = "view ray x depth", .help = "camera-relative: the pixel's ray times linear depth; as exact as the depth format"},
  {.value = at(PositionReconstruct::inverse_viewproj), .id = "inverse-viewproj", .label = "inverse view-projection", .help = "a float 4x4 inverse: adds its own noise, larger than 24-bit depth's at a distance", .source = "nclgl tutorial 15, pointlightfragment.glsl lines 23-24"},
  {.value = at(PositionReconstruct::inverse_viewproj_varying), .id = "inverse-viewproj-varying", .label = "inverse, per vertex", .help = "the inverse is taken in the vertex shader and passed on as four varyings: interpolation adds its own noise", .source = "nclgl tutorial 15, pointlightvertex.glsl", .pitfall = "inverse-matrix-varying"},
};
constexpr ValueRow kDepthFormat[] = {
  {.value = at(DepthFormat::d16), .id = "d16", .label = "D16", .help = "16-bit fixed point", .cost = "2 B/px"},
  {.value = at(DepthFormat::d24), .id = "d24", .label = "D24", .help = "24-bit fixed point, stored in 32", .cost = "4 B/px"},
  {.value = at(DepthFormat::d32f), .id = "d32f", .label = "D32F", .help = "32-bit float; no better than D24 unless reversed", .cost = "4 B/px"},
  {.value = at(DepthFormat::d32f_reversed), .id = "d32f-reversed", .label = "D32F reversed", .help = "1 near, 0 far, clip depth 0..1: the float's fine steps near 0 meet the far end's coarse depths", .cost = "4 B/px", .source = "Reed 2015, Depth Precision Visualized", .needs = Feature::clip_control},
};
constexpr ValueRow kLightMethod[] = {
  {.value = at(LightMethod::forward), .id = "forward", .label = "forward", .help = "no G-buffer: every fragment shades every light, seen in the end or not", .cost = "fragments x lights shaded; no G-buffer"},
  {.value = at(LightMethod::forward_prepass), .id = "forward-prepass", .label = "forward after a depth pass", .help = "depth first, then only the visible fragments shade every light", .cost = "geometry twice; no G-buffer"},
  {.value = at(LightMethod::forward_multipass), .id = "forward-multipass", .label = "forward, a pass per light", .help = "all geometry again for every light, added up: what deferred rendering was invented against", .cost = "geometry x (lights + 1); no G-buffer"},
  {.value = at(LightMethod::prepass), .id = "prepass", .label = "deferred lighting", .help = "normal and gloss first, full-screen light into two targets, then geometry again with its materials", .cost = "geometry twice; a thin G-buffer", .source = "Engel 2008, Light Pre-Pass Renderer"},
  {.value = at(LightMethod::fullscreen), .id = "fullscreen", .label = "full screen", .help = "one pass: every pixel shades every light", .cost = "pixels x lights shaded"},
  {.value = at(LightMethod::fullscreen_radius), .id = "fullscreen-radius", .label = "full screen + distance test", .help = "one pass: every pixel reads every light and shades those in range", .cost = "pixels x lights read", .source = "de Vries 2014, LearnOpenGL, Deferred Shading"},
  {.value = at(LightMethod::volumes), .id = "volumes", .label = "light volumes", .help = "one mesh per light, a sphere or a spot's cone: only the pixels under it are shaded", .cost = "1 draw and 1 blend per light", .source = "nclgl tutorial 15, DrawPointLights"},
  {.value = at(LightMethod::volumes_instanced), .id = "volumes-instanced", .label = "light volumes, instanced", .help = "all volumes of a shape in one draw; a culling rule that flips takes two, each leaving out the other's lights", .cost = "5 draws at most, 1 blend per light"},
  {.value = at(LightMethod::volumes_stencil), .id = "volumes-stencil", .label = "light volumes + stencil", .help = "each volume marks the pixels whose surface is inside it, then only these are shaded", .cost = "2 draws per light, 1 B/px of stencil, a copy of the depth", .source = "Everitt and Kilgard 2002, Practical and Robust Stenciled Shadow Volumes (z-fail)", .needs = Feature::depth_clamp},
  {.value = at(LightMethod::quads), .id = "quads", .label = "screen rectangles", .help = "one rectangle per light, the exact bounds of its sphere on screen, all in one draw", .cost = "1 draw, 1 blend per light; the corners outside the sphere are shaded too", .source = "Mara and McGuire 2013, 2D Polyhedral Bounds of a Clipped, Perspective-Projected 3D Sphere"},
  {.value = at(LightMethod::disc), .id = "disc", .label = "flat discs", .help = "one 36-gon per light through its centre, parallel to the image plane: smaller than the sphere's outline", .cost = "1 draw, 1 blend per light", .source = "engine blog, part 30, geopointlight", .pitfall = "flat-circle-undercovers"},
  {.value = at(LightMethod::tiled), .id = "tiled", .label = "tiles, 16 x 16 px", .help = "a compute shader lists the lights of each tile, from its nearest surface to its farthest; its pixels test only these", .cost = "lights x tiles tested; no blend", .source = "Andersson 2009, Parallel Graphics in Frostbite; Lauritzen 2010, Deferred Rendering for Current and Future Rendering Pipelines", .needs = Feature::compute},
  {.value = at(LightMethod::clustered), .id = "clustered", .label = "clusters, 32 x 18 x 24", .help = "the view is cut into cells, slices in depth included; a pixel tests only the lights that reach its cell", .cost = "lists are built on the CPU each frame; no blend", .source = "Olsson, Billeter and Assarsson 2012, Clustered Deferred and Forward Shading; Persson 2013, Practical Clustered Shading"},
  {.value = at(LightMethod::auto_), .id = "auto", .label = "automatic", .help = "the sound method with the least work for this frame, as estimated; the choice and its reason are shown"},
};
constexpr ValueRow kLightCull[] = {
  {.value = at(LightCull::flip), .id = "flip", .label = "flip", .help = "back faces when the camera is nearer than the range, else front faces (as source 0)", .source = "nclgl tutorial 15, renderer.cpp lines 228-234", .pitfall = "near-plane-cut"},
  {.value = at(LightCull::back), .id = "back", .label = "back", .help = "front faces only: nothing is left to draw once the camera is inside", .pitfall = "backface-cull-inside"},
  {.value = at(LightCull::none), .id = "none", .label = "none", .help = "both faces: every light counts twice when seen from outside", .cost = "2 x pairs", .pitfall = "no-culling-doubles"},
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
  {.value = at(VolumeFit::inscribed), .id = "inscribed", .label = "inscribed", .help = "vertices on the sphere: the faces cut into it and notches appear at the rim", .pitfall = "inscribed-mesh"},
  {.value = at(VolumeFit::circumscribed), .id = "circumscribed", .label = "circumscribed", .help = "scaled by 1/inradius: the mesh contains the sphere", .cost = "up to 24 % more pairs at level 0"},
};
constexpr ValueRow kVolumeClip[] = {
  {.value = at(VolumeClip::none), .id = "none", .label = "not clipped", .help = "vertices are put at mid-depth, so near and far planes cut nothing"},
  {.value = at(VolumeClip::planes), .id = "planes", .label = "near and far clip", .help = "the planes cut the mesh as in the sources: whole lights can vanish", .pitfall = "near-plane-cut"},
};
constexpr ValueRow kVolumeDepth[] = {
  {.value = at(VolumeDepth::none), .id = "none", .label = "no depth test", .help = "every pixel under the volume is shaded, near or far"},
  {.value = at(VolumeDepth::less_equal), .id = "less-equal", .label = "front faces before the surface", .help = "leaves out surfaces in front of the volume; needs cull back, and with it loses the light that the camera is inside", .cost = "a copy of the depth", .pitfall = "backface-cull-inside", .needs = Feature::depth_clamp},
  {.value = at(VolumeDepth::greater_equal), .id = "greater-equal", .label = "back faces behind the surface", .help = "leaves out surfaces behind the volume; needs cull front, and is right inside and outside", .cost = "a copy of the depth", .needs = Feature::depth_clamp},
};
constexpr ValueRow kAccumulationFormat[] = {
  {.value = at(AccumulationFormat::rgba8), .id = "rgba8", .label = "RGBA8", .help = "saturates at 1 and drops faint lights", .cost = "4 B/px a target"},
  {.value = at(AccumulationFormat::r11g11b10f), .id = "r11g11b10f", .label = "R11G11B10F", .help = "6 or 5 bits of mantissa: many lights stop adding, blue first", .cost = "4 B/px a target"},
  {.value = at(AccumulationFormat::rgba16f), .id = "rgba16f", .label = "RGBA16F", .help = "11 bits of mantissa; drivers may truncate at every blend", .cost = "8 B/px a target"},
  {.value = at(AccumulationFormat::rgba32f), .id = "rgba32f", .label = "RGBA32F", .help = "float sums: what accuracy is judged in", .cost = "16 B/px a target"},
};
constexpr ValueRow kAccumulationTargets[] = {
  {.value = at(AccumulationTargets::one), .id = "one", .label = "one target", .help = "albedo x diffuse + specular is summed: one blend per light, nothing to look at apart"},
  {.value = at(AccumulationTargets::split), .id = "split", .label = "diffuse | specular", .help = "two targets: each can be seen, albedo is multiplied once", .cost = "2 targets"},
};
constexpr ValueRow kBackgroundSkip[] = {
  {.value = at(BackgroundSkip::depth), .id = "depth", .label = "by depth", .help = "a pixel at the far value has no surface and is not shaded"},
  {.value = at(BackgroundSkip::stencil), .id = "stencil", .label = "by stencil", .help = "surfaces mark the stencil buffer, and the light passes are tested against it", .cost = "8 bits beside the depth", .source = "tutorial 08-2, the stencil test of both passes"},
  {.value = at(BackgroundSkip::alpha), .id = "alpha", .label = "by alpha", .help = "a stored alpha below 0.1 means no surface: needs a cleared target and a layout with a free alpha", .source = "engine blog, geomainpass.fs"},
  {.value = at(BackgroundSkip::none), .id = "none", .label = "not skipped", .help = "the background's clear colour is taken for a surface at the far plane and lit", .cost = "every pixel shaded", .source = "nclgl tutorial 15, FillBuffers to CombineBuffers", .pitfall = "background-shaded"},
};
constexpr ValueRow kTangents[] = {
  {.value = at(Tangents::vertex), .id = "vertex", .label = "per vertex", .help = "tangent frames come with the mesh"},
  {.value = at(Tangents::derivatives), .id = "derivatives", .label = "from derivatives", .help = "a frame per pixel from how position and texture coordinates change: no vertex data, blocky at silhouettes", .source = "Schueler 2006, Normal Mapping Without Precomputed Tangents"},
  {.value = at(Tangents::matrix_columns), .id = "matrix-columns", .label = "columns of the matrix", .help = "the object's x and y axes taken for tangent and bitangent: right only where a face looks along its +Z", .source = "engine blog, part 31", .pitfall = "tangent-from-matrix"},
};
constexpr ValueRow kAntialias[] = {
  {.value = at(Antialias::none), .id = "none", .label = "none", .help = "one sample per pixel"},
  {.value = at(Antialias::edge_blur), .id = "edge-blur", .label = "edges blurred", .help = "after lighting, pixels beside a step in depth or normal are mixed with their neighbours", .cost = "one pass", .source = "Shishkovtsov 2005, Deferred Shading in S.T.A.L.K.E.R."},
  {.value = at(Antialias::msaa_resolved), .id = "msaa-resolved", .label = "MSAA, resolved G-buffer", .help = "four samples averaged before lighting: at edges normals and depths that no surface has", .cost = "4 x G-buffer bytes while it is drawn", .pitfall = "msaa-resolved-gbuffer"},
};
constexpr ValueRow kDrawOrder[] = {
  {.value = at(DrawOrder::near_far), .id = "near-far", .label = "near to far", .help = "objects sorted by distance, nearest first"},
  {.value = at(DrawOrder::far_near), .id = "far-near", .label = "far to near", .help = "the other way round: every surface behind another is drawn first, and paid for"},
  {.value = at(DrawOrder::seeded), .id = "seeded", .label = "shuffled", .help = "an order that has nothing to do with the view, the same every time"},
};
constexpr ValueRow kVolumeOverlay[] = {
  {.value = at(VolumeOverlay::off), .id = "off", .label = "off", .help = "no light volume is drawn over the picture"},
  {.value = at(VolumeOverlay::picked), .id = "picked", .label = "picked light", .help = "the wire of the picked light's volume; parts behind a surface are faint"},
  {.value = at(VolumeOverlay::all), .id = "all", .label = "all lights", .help = "the wires of all volumes in their lights' colours"},
};
constexpr ValueRow kErrorOf[] = {
  {.value = at(ErrorOf::final), .id = "final", .label = "final", .help = "as displayed, in codes of 255: what a class can see"},
  {.value = at(ErrorOf::lit), .id = "lit", .label = "lit", .help = "linear radiance before the display"},
  {.value = at(ErrorOf::diffuse_light), .id = "diffuse-light", .label = "diffuse light", .help = "the sum of diffuse light, without albedo"},
  {.value = at(ErrorOf::specular_light), .id = "specular-light", .label = "specular light", .help = "the sum of highlights"},
  {.value = at(ErrorOf::normal), .id = "normal", .label = "normal", .help = "the angle to the true normal, degrees"},
  {.value = at(ErrorOf::position), .id = "position", .label = "position", .help = "the distance to the true point, world units"},
  {.value = at(ErrorOf::depth), .id = "depth", .label = "depth", .help = "along the view axis, world units: farther than it is, or nearer"},
  {.value = at(ErrorOf::albedo), .id = "albedo", .label = "albedo", .help = "linear, the channel that is off most"},
  {.value = at(ErrorOf::roughness), .id = "roughness", .label = "roughness", .help = "as stored, 0..1"},
};
constexpr ValueRow kErrorScale[] = {
  {.value = at(ErrorScale::magnitude), .id = "magnitude", .label = "magnitude", .help = "how far off, from black to yellow (magma)", .source = "Smith and van der Walt 2015, matplotlib: magma"},
  {.value = at(ErrorScale::with_sign), .id = "signed", .label = "signed", .help = "too much is red, too little blue, white is right", .source = "Brewer 2002, ColorBrewer: RdBu"},
};
constexpr ValueRow kLightMarkers[] = {
  {.value = at(LightMarkers::off), .id = "off", .label = "off", .help = "lights are not drawn"},
  {.value = at(LightMarkers::on), .id = "on", .label = "cubes", .help = "a small cube in its colour at each point and spot light, drawn forward after lighting", .source = "de Vries 2014, LearnOpenGL, Deferred Shading"},
};
// clang-format on

}  // namespace

#define GBL_ROWS(Enum, table)                                \
  static_assert(in_order(table), "row i must have value i"); \
  template <>                                                \
  std::span<const ValueRow> rows<Enum>() {                   \
    return table;                                            \
  }
GBL_ROWS(LightSource, kLightSource)
GBL_ROWS(LightSpot, kLightSpot)
GBL_ROWS(Attenuation, kAttenuation)
GBL_ROWS(RangeKind, kRangeKind)
GBL_ROWS(ShadingModel, kShadingModel)
GBL_ROWS(BackgroundFill, kBackgroundFill)
GBL_ROWS(NormalMap, kNormalMap)
GBL_ROWS(AlbedoSource, kAlbedoSource)
GBL_ROWS(Colour, kColour)
GBL_ROWS(Layout, kLayout)
GBL_ROWS(NormalEncoding, kNormalEncoding)
GBL_ROWS(NormalSpace, kNormalSpace)
GBL_ROWS(PositionSource, kPositionSource)
GBL_ROWS(PositionReconstruct, kPositionReconstruct)
GBL_ROWS(DepthFormat, kDepthFormat)
GBL_ROWS(LightMethod, kLightMethod)
GBL_ROWS(LightCull, kLightCull)
GBL_ROWS(VolumeLevel, kVolumeLevel)
GBL_ROWS(VolumeFit, kVolumeFit)
GBL_ROWS(VolumeClip, kVolumeClip)
GBL_ROWS(VolumeDepth, kVolumeDepth)
GBL_ROWS(AccumulationFormat, kAccumulationFormat)
GBL_ROWS(AccumulationTargets, kAccumulationTargets)
GBL_ROWS(BackgroundSkip, kBackgroundSkip)
GBL_ROWS(Tangents, kTangents)
GBL_ROWS(Antialias, kAntialias)
GBL_ROWS(DrawOrder, kDrawOrder)
GBL_ROWS(VolumeOverlay, kVolumeOverlay)
GBL_ROWS(LightMarkers, kLightMarkers)
GBL_ROWS(ErrorOf, kErrorOf)
GBL_ROWS(ErrorScale, kErrorScale)
#undef GBL_ROWS

int parse_id(std::span<const ValueRow> table, std::string_view id, std::string_view where) {
  std::vector<std::string_view> known;
  for (const ValueRow& r : table) {
    if (r.id == id) return r.value;
    known.push_back(r.id);
  }
  throw Error(ExitCode::bad_input, where, fmt::format("unknown value '{}'", id), suggest(id, known));
}

}  // namespace gbl
