#include "renderer/gbuffer/gbuffer_axes.h"

#include "renderer/rows/value_table.h"

namespace gbl {
namespace {

// clang-format off
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
  {.value = at(PositionReconstruct::inverse_viewproj_varying), .id = "inverse-viewproj-varying", .label = "inverse, per vertex", .help = "the inverse is taken in the vertex shader and passed on as four varyings: interpolation adds its own noise", .source = "nclgl tutorial 15, pointlightvertex.glsl", .pitfall = Pitfall::inverse_matrix_varying},
};
constexpr ValueRow kDepthFormat[] = {
  {.value = at(DepthFormat::d16), .id = "d16", .label = "D16", .help = "16-bit fixed point", .cost = "2 B/px"},
  {.value = at(DepthFormat::d24), .id = "d24", .label = "D24", .help = "24-bit fixed point, stored in 32", .cost = "4 B/px"},
  {.value = at(DepthFormat::d32f), .id = "d32f", .label = "D32F", .help = "32-bit float; no better than D24 unless reversed", .cost = "4 B/px"},
  {.value = at(DepthFormat::d32f_reversed), .id = "d32f-reversed", .label = "D32F reversed", .help = "1 near, 0 far, clip depth 0..1: the float's fine steps near 0 meet the far end's coarse depths", .cost = "4 B/px", .source = "Reed 2015, Depth Precision Visualized", .needs = Feature::clip_control},
  {.value = at(DepthFormat::auto_), .id = "auto", .label = "auto", .help = "D32F reversed; on a driver without clip control D32F, with the near plane moved out to the scene", .cost = "4 B/px"},
};
// clang-format on

}  // namespace

GBL_ROWS(NormalSpace, kNormalSpace)
GBL_ROWS(PositionSource, kPositionSource)
GBL_ROWS(PositionReconstruct, kPositionReconstruct)
GBL_ROWS(DepthFormat, kDepthFormat)

}  // namespace gbl
