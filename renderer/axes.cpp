#include "renderer/axes.h"

#include <fmt/format.h>
#include <vector>

#include "renderer/error.h"

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
  {.value = at(Layout::float32), .id = "float32", .label = "float, nothing lost", .help = "albedo, roughness, F0, metal, emission and ambient occlusion in floats: the zero-error end", .cost = "48 B/px"},
};
constexpr ValueRow kNormalEncoding[] = {
  {.value = at(NormalEncoding::oct16), .id = "oct16", .label = "octahedral 16+16", .help = "the sphere unfolded to a square, two 16-bit codes", .cost = "32 bits", .source = "Meyer et al. 2010, On floating-point normal vectors; Cigolle et al. 2014, Survey of efficient representations"},
  {.value = at(NormalEncoding::oct8), .id = "oct8", .label = "octahedral 8+8", .help = "the sphere unfolded to a square, two 8-bit codes: facets in highlights", .cost = "16 bits", .source = "Cigolle et al. 2014, Survey of efficient representations for independent unit vectors"},
  {.value = at(NormalEncoding::xyz8), .id = "xyz8", .label = "xyz 8+8+8", .help = "n * 0.5 + 0.5 in three 8-bit codes: most codes are no unit vector", .cost = "32 bits (24 used)", .source = "nclgl tutorial 15, bufferFragment.glsl line 23"},
  {.value = at(NormalEncoding::stereo16f), .id = "stereo16f", .label = "stereographic 16F+16F", .help = "projected from the -Z pole to a plane: excellent, but no code for the pole itself", .cost = "32 bits", .source = "tutorial 9, step 3 (it says \"stereoscopic\")", .pitfall = "stereographic-pole"},
};
constexpr ValueRow kNormalSpace[] = {
  {.value = at(NormalSpace::world), .id = "world", .label = "world", .help = "normals are stored along the world's axes"},
};
constexpr ValueRow kPositionSource[] = {
  {.value = at(PositionSource::depth), .id = "depth", .label = "from depth", .help = "position is recomputed from the depth buffer", .cost = "no attachment"},
};
constexpr ValueRow kPositionReconstruct[] = {
  {.value = at(PositionReconstruct::view_ray), .id = "view-ray", .label = "view ray x depth", .help = "camera-relative: the pixel's ray times linear depth; as exact as the depth format"},
  {.value = at(PositionReconstruct::inverse_viewproj), .id = "inverse-viewproj", .label = "inverse view-projection", .help = "a float 4x4 inverse: adds its own noise, larger than 24-bit depth's at a distance", .source = "nclgl tutorial 15, pointlightfragment.glsl lines 23-24"},
};
constexpr ValueRow kDepthFormat[] = {
  {.value = at(DepthFormat::d16), .id = "d16", .label = "D16", .help = "16-bit fixed point", .cost = "2 B/px"},
  {.value = at(DepthFormat::d24), .id = "d24", .label = "D24", .help = "24-bit fixed point, stored in 32", .cost = "4 B/px"},
  {.value = at(DepthFormat::d32f), .id = "d32f", .label = "D32F", .help = "32-bit float; no better than D24 unless reversed", .cost = "4 B/px"},
};
constexpr ValueRow kLightMethod[] = {
  {.value = at(LightMethod::fullscreen), .id = "fullscreen", .label = "full screen", .help = "one pass: every pixel shades every light", .cost = "pixels x lights shaded"},
  {.value = at(LightMethod::fullscreen_radius), .id = "fullscreen-radius", .label = "full screen + distance test", .help = "one pass: every pixel reads every light and shades those in range", .cost = "pixels x lights read", .source = "de Vries 2014, LearnOpenGL, Deferred Shading"},
  {.value = at(LightMethod::volumes), .id = "volumes", .label = "light volumes", .help = "one sphere mesh per light: only the pixels under it are shaded", .cost = "1 draw and 1 blend per light", .source = "nclgl tutorial 15, DrawPointLights"},
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
};
constexpr ValueRow kTangents[] = {
  {.value = at(Tangents::vertex), .id = "vertex", .label = "per vertex", .help = "tangent frames come with the mesh"},
};
constexpr ValueRow kAntialias[] = {
  {.value = at(Antialias::none), .id = "none", .label = "none", .help = "one sample per pixel"},
};
constexpr ValueRow kDrawOrder[] = {
  {.value = at(DrawOrder::near_far), .id = "near-far", .label = "near to far", .help = "objects sorted by distance, nearest first"},
};
constexpr ValueRow kVolumeOverlay[] = {
  {.value = at(VolumeOverlay::off), .id = "off", .label = "off", .help = "no light volume is drawn over the picture"},
  {.value = at(VolumeOverlay::picked), .id = "picked", .label = "picked light", .help = "the wire of the picked light's volume; parts behind a surface are faint"},
  {.value = at(VolumeOverlay::all), .id = "all", .label = "all lights", .help = "the wires of all volumes in their lights' colours"},
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
