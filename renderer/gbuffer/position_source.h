#pragma once
// Ways to get a position back, and how far off each is: what is stored is rounded as its format rounds, what the
// shaders do in float is done in float. World units, for the camera of source 0.
#include <span>
#include <string>

#include "renderer/gbuffer/gbuffer_axes.h"
#include "renderer/scene/camera.h"

namespace gbl {

inline constexpr double kPositionRanges[] = {10, 100, 1000, 9000};  // distances along the view axis, near 1, far 10000

// Largest error in world units at each of these distances, to two digits; asserted by a test.
struct PositionRow {
  PositionSource source;
  PositionReconstruct reconstruct;  // of source `depth` only
  DepthFormat format;               // of source `depth` only
  double max_error[4];
};
std::span<const PositionRow> position_rows();

// A pixel whose surface is known.
struct SurfacePixel {
  Camera camera;
  double aspect;
  glm::vec2 ndc;        // of the pixel's centre, -1..1
  glm::dvec3 relative;  // to the camera, along the world's axes
  float window_depth;   // as it is stored
};
// What the lighting reads by this way, relative to the camera; max_error is not asked for.
glm::dvec3 position_read(const PositionRow&, const SurfacePixel&);

DepthRuns depth_runs(DepthFormat);

std::string id_of(const PositionRow&);  // "world16f", "depth/d24/view-ray"

// Measured anew, over a grid of pixels of a 16:9 picture.
double largest_position_error(const PositionRow&, double range);

}  // namespace gbl
