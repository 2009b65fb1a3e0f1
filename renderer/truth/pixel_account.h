#pragma once
// Why one pixel looks as it does: what the frame has there beside the truth, the lights that reach it, and the sum written
// out term by term, with the first that goes wrong.
#include <optional>
#include <string>
#include <vector>

#include "renderer/inspect/pixel_probe.h"
#include "renderer/truth/position_routes.h"
#include "renderer/truth/truth_geometry.h"

namespace gbl {

struct LightShare {
  int index = 0;                   // as view.pick counts
  double distance = 0, range = 0;  // world units; range: kEndless for a light without end
  double arriving = 0;             // share of its light, 0..1
  double n_dot_l = 0;              // -1..1; 0 and below: the surface is turned away
  bool hidden = false;             // something stands in its way, and it has a shadow: nothing of it arrives
  glm::dvec3 diffuse{0};           // radiance that leaves the surface, albedo included
  glm::dvec3 specular{0};
  double share = 0;           // of the light of all, by luminance
  std::optional<int> shaded;  // how often this method shaded it here; empty: not counted
};
inline constexpr size_t kCountedLights = 16;  // in the window: the strongest, one a frame

// "missed", "counted twice", ...; empty: as it should be, or not counted.
std::string verdict_of(const LightShare&);

struct AccountLine {
  const char* what;
  const char* unit;
  std::vector<double> drawn;  // empty: not stored
  std::vector<double> truth;
  double error = 0;  // largest difference of a channel, in the unit; of a normal the angle in degrees
  bool off = false;  // of a term: alone it moves the picture by more than half a code
};

struct PixelAccount {
  glm::ivec2 pixel{0};
  bool surface = false;         // of the truth
  SeenSurface seen;             // by the truth
  SeenSurface shown;            // by the frame
  bool tie = false;             // another than the truth's, but at an edge (ties.h)
  glm::dvec3 true_position{0};  // of a surface, in the world
  DepthAccount depth;
  std::vector<PositionRoute> routes;  // empty: no method of these settings reads a position
  std::vector<AccountLine> stored;    // position, normal, albedo, ...
  std::vector<AccountLine> terms;     // of the sum, in the order in which it is made
  int first_off = -1;                 // of the terms; -1: none
  std::vector<LightShare> lights;     // that reach the surface, the strongest first
};

// Where frame and reference see different surfaces, a sentence that says so; else empty.
std::string other_surface_note(const PixelAccount&);

// probe: of a frame drawn with these settings, resolved; texel: what the reference saw there. What the frame shows there,
// and whether it is a tie, is left to the caller.
PixelAccount account_of(const Settings&, const Scene&, const SeenTexel&, const PixelProbe&);

}  // namespace gbl
