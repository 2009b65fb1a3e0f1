#pragma once
// What a frame's lighting will do and how long it will take, guessed before it is drawn: a full-screen loop over
// 16 384 lights can take minutes on a software driver, and a window must not freeze for that.
#include <map>
#include <vector>

#include "renderer/frame/work_weights.h"
#include "renderer/options/settings.h"
#include "renderer/scene/scene.h"

namespace gbl {

struct ResolvedFrame;

// How many pairs of pixel and light there are of each sort: everything that the methods' work follows from.
struct LightsInView {
  double pixels = 0, lights = 0;
  double reached = 0;  // in range; a guess, for nobody knows the surfaces' depths yet
  double under_volumes = 0;
  double under_quads = 0;
  double in_tiles = 0;          // in the lists of the pixels' tiles …
  double in_clusters = 0;       // … and of their clusters
  double volume_triangles = 0;  // of one volume's mesh
};
// Of many lights every so manieth stands for all, so that a window can ask in every frame.
LightsInView lights_in_view(const Settings&, const std::vector<Light>&);

struct LightWork {
  double tested = 0, shaded = 0;  // pairs, as a frame report counts them
  WorkCounts counts;              // all work of the lighting pass …
  double units = 0;               // … and what it comes to, in turns of the full-screen loop
};
LightWork work_of(LightMethod, const LightsInView&);  // not of auto

// Units of work of a frame. Of auto: of its choice where nothing beyond the core path is available.
double estimate_work(const Settings&, const std::vector<Light>&);

// Nanoseconds per unit of work, learnt from the frames drawn so far, for each method by itself: what a method does beyond
// its units must not make the others look slow.
class FrameCost {
 public:
  explicit FrameCost(bool software_driver);
  void learn(LightMethod, double work, double lighting_ms);
  double predict_ms(const ResolvedFrame&) const;

  // The size at which the frame is predicted to stay within budget_ms: the size asked for, or smaller in the same
  // proportions, never below 64 pixels a side.
  glm::ivec2 affordable_size(const ResolvedFrame&, glm::ivec2 asked, double budget_ms) const;

 private:
  double ns_per_unit(LightMethod) const;
  double ms_of(LightMethod, double work, glm::ivec2 size) const;
  double first_guess_ns_;
  std::map<LightMethod, double> learnt_ns_;
  double ns_per_pixel_;  // all passes but lighting
};

}  // namespace gbl
