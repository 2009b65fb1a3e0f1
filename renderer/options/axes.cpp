#include "renderer/options/axes.h"

#include "renderer/rows/value_table.h"

namespace gbl {
namespace {

// clang-format off
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
constexpr ValueRow kHeightMap[] = {
  {.value = at(HeightMap::off), .id = "off", .label = "off", .help = "surfaces are as flat as their triangles"},
  {.value = at(HeightMap::on), .id = "on", .label = "on", .help = "surfaces with a height map lie below their triangles as it says; the flat triangles decide which surface hides which, so that what shows from inside that depth counts as error"},
};
constexpr ValueRow kParallaxMethod[] = {
  {.value = at(ParallaxMethod::none), .id = "none", .label = "none", .help = "surfaces stay flat"},
  {.value = at(ParallaxMethod::offset), .id = "offset", .label = "offset", .help = "one look at the height where the flat surface is seen: right where the surface is level", .cost = "1 texel", .source = "Kaneko et al. 2001, Detailed Shape Representation with Parallax Mapping"},
  {.value = at(ParallaxMethod::steep), .id = "steep", .label = "steep", .help = "down in equal steps, to the first below the surface: stairs as high as a step", .cost = "parallax.steps texels at most", .source = "McGuire and McGuire 2005, Steep Parallax Mapping"},
  {.value = at(ParallaxMethod::occlusion), .id = "occlusion", .label = "occlusion", .help = "steep, then a straight line through the last two heights", .cost = "parallax.steps texels at most", .source = "Tatarchuk 2006, Dynamic Parallax Occlusion Mapping with Approximate Soft Shadows"},
  {.value = at(ParallaxMethod::relief), .id = "relief", .label = "relief", .help = "steep, then the last step is halved eight times", .cost = "parallax.steps texels at most, and 8", .source = "Policarpo et al. 2005, Real-Time Relief Mapping on Arbitrary Polygonal Surfaces"},
};
constexpr ValueRow kParallaxDepth[] = {
  {.value = at(ParallaxDepth::displaced), .id = "displaced", .label = "displaced", .help = "the surface is stored, lit and shadowed where it is seen", .cost = "depth is written by the shader: no early test"},
  {.value = at(ParallaxDepth::flat), .id = "flat", .label = "flat", .help = "only textures move: lights and shadows fall on the flat surface", .pitfall = Pitfall::parallax_flat_depth},
};
constexpr ValueRow kTessellationMode[] = {
  {.value = at(TessellationMode::off), .id = "off", .label = "off", .help = "height maps are looked into (parallax.method): the mesh is as it is"},
  {.value = at(TessellationMode::uniform), .id = "uniform", .label = "uniform", .help = "every edge of a mesh with a height map is cut into as many pieces as the level says, and their corners are moved by it: outlines and shadows follow", .cost = "1.5 x level x level triangles for one", .needs = Feature::tessellation},
  {.value = at(TessellationMode::by_distance), .id = "by-distance", .label = "by distance", .help = "as many along each edge as its length over its distance asks for: near ones fine, far ones coarse", .cost = "1.5 x level x level triangles for one at most", .source = "Cantlay 2011, DirectX 11 Terrain Tessellation", .needs = Feature::tessellation},
};
constexpr ValueRow kAlbedoSource[] = {
  {.value = at(AlbedoSource::textured), .id = "textured", .label = "textured", .help = "the material's own colour"},
  {.value = at(AlbedoSource::white), .id = "white", .label = "white", .help = "every surface white: the lighting alone"},
};
constexpr ValueRow kColour[] = {
  {.value = at(Colour::srgb), .id = "srgb", .label = "sRGB", .help = "textures decoded, display encoded by the sRGB curve", .source = "IEC 61966-2-1:1999"},
  {.value = at(Colour::as_tutorial), .id = "as-tutorial", .label = "as the tutorial", .help = "texels used as if linear and shown unencoded, as the sources print it"},
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
  {.value = at(AccumulationTargets::folded), .id = "folded", .label = "none: folded", .help = "a method that reads each pixel once finishes the picture, and light is kept there alone, in accumulation.format; others blend into targets as ever"},
};
constexpr ValueRow kBackgroundSkip[] = {
  {.value = at(BackgroundSkip::depth), .id = "depth", .label = "by depth", .help = "a pixel at the far value has no surface and is not shaded"},
  {.value = at(BackgroundSkip::stencil), .id = "stencil", .label = "by stencil", .help = "surfaces mark the stencil buffer, and the light passes are tested against it", .cost = "8 bits beside the depth", .source = "tutorial 08-2, the stencil test of both passes"},
  {.value = at(BackgroundSkip::alpha), .id = "alpha", .label = "by alpha", .help = "a stored alpha below 0.1 means no surface: needs a cleared target and a layout with a free alpha", .source = "engine blog, geomainpass.fs"},
  {.value = at(BackgroundSkip::none), .id = "none", .label = "not skipped", .help = "the background's clear colour is taken for a surface at the far plane and lit", .cost = "every pixel shaded", .source = "nclgl tutorial 15, FillBuffers to CombineBuffers", .pitfall = Pitfall::background_shaded},
};
constexpr ValueRow kTangents[] = {
  {.value = at(Tangents::vertex), .id = "vertex", .label = "per vertex", .help = "tangent frames come with the mesh"},
  {.value = at(Tangents::derivatives), .id = "derivatives", .label = "from derivatives", .help = "a frame per pixel from how position and texture coordinates change: no vertex data, blocky at silhouettes", .source = "Schueler 2006, Normal Mapping Without Precomputed Tangents"},
  {.value = at(Tangents::matrix_columns), .id = "matrix-columns", .label = "columns of the matrix", .help = "the object's x and y axes taken for tangent and bitangent: right only where a face looks along its +Z", .source = "engine blog, part 31", .pitfall = Pitfall::tangent_from_matrix},
};
constexpr ValueRow kAntialias[] = {
  {.value = at(Antialias::none), .id = "none", .label = "none", .help = "one sample per pixel"},
  {.value = at(Antialias::edge_blur), .id = "edge-blur", .label = "edges blurred", .help = "after lighting, pixels beside a step in depth or normal are mixed with their neighbours", .cost = "one pass", .source = "Shishkovtsov 2005, Deferred Shading in S.T.A.L.K.E.R."},
  {.value = at(Antialias::msaa_resolved), .id = "msaa-resolved", .label = "MSAA, resolved G-buffer", .help = "four samples averaged before lighting: at edges normals and depths that no surface has", .cost = "4 x G-buffer bytes while it is drawn", .pitfall = Pitfall::msaa_resolved_gbuffer},
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
// clang-format on

}  // namespace

GBL_ROWS(ShadingModel, kShadingModel)
GBL_ROWS(BackgroundFill, kBackgroundFill)
GBL_ROWS(NormalMap, kNormalMap)
GBL_ROWS(HeightMap, kHeightMap)
GBL_ROWS(ParallaxMethod, kParallaxMethod)
GBL_ROWS(ParallaxDepth, kParallaxDepth)
GBL_ROWS(TessellationMode, kTessellationMode)
GBL_ROWS(AlbedoSource, kAlbedoSource)
GBL_ROWS(Colour, kColour)
GBL_ROWS(AccumulationFormat, kAccumulationFormat)
GBL_ROWS(AccumulationTargets, kAccumulationTargets)
GBL_ROWS(BackgroundSkip, kBackgroundSkip)
GBL_ROWS(Tangents, kTangents)
GBL_ROWS(Antialias, kAntialias)
GBL_ROWS(DrawOrder, kDrawOrder)
GBL_ROWS(VolumeOverlay, kVolumeOverlay)
GBL_ROWS(ErrorOf, kErrorOf)
GBL_ROWS(ErrorScale, kErrorScale)

}  // namespace gbl
