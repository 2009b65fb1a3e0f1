#pragma once
// The held pixel's depth with all of its digits, and its position by each way in which a frame can store it.
#include <string>
#include <vector>

#include "renderer/inspect/pixel_probe.h"

namespace gbl {

// Depth as it is stored.
struct DepthAccount {
  uint32_t code = 0;  // of a float format its bits
  int bits = 0;
  bool floating = false;
  double window = 0;               // 0..1
  double distance = 0, truth = 0;  // along the view axis, world units
  double step = 0;                 // from this code to the next that lies farther, world units
};
std::string code_text(const DepthAccount&);  // "0x7f3a21 of 24 bits"

// One way of position.source and position.reconstruct: what the lighting would read by it here. From depth it reads what the
// frame has stored; what these settings do not store is the truth, rounded as its format rounds to nearest.
struct PositionRoute {
  PositionSource source;
  PositionReconstruct reconstruct;  // of source `depth` only
  glm::dvec3 position;              // in the world
  double error;                     // distance from the truth, world units
  bool used;                        // by these settings
};
std::string name_of(const PositionRoute&);          // "depth, view-ray", "world16f"
std::string_view pitfall_of(const PositionRoute&);  // empty: it is sound

// settings: of the frame, resolved; relative: the true position, seen from the camera along the world's axes.
DepthAccount depth_account(const Settings&, const PixelProbe&, const glm::dvec3& relative);
std::vector<PositionRoute> position_routes(const Settings&, const PixelProbe&, const glm::dvec3& relative);

}  // namespace gbl
