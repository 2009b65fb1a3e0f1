#pragma once
// How long a frame will take, guessed before it is drawn: a full-screen loop over 16 384 lights can take minutes on
// a software driver, and a window must not freeze for that.
#include "renderer/lights.h"
#include "renderer/settings.h"

namespace gbl {

// Work of the lighting pass in units of one shaded pair; a pair that is only tested counts kTestCost.
double estimate_work(const Settings&, const std::vector<Light>&);

// Nanoseconds per unit of work, learnt from the frames drawn so far.
class FrameCost {
 public:
  explicit FrameCost(bool software_driver);
  void learn(double work, double lighting_ms);
  double predict_ms(const Settings&, const std::vector<Light>&) const;

  // The size at which the frame is predicted to stay within budget_ms: the size asked for, or smaller in the same
  // proportions, never below 64 pixels a side.
  glm::ivec2 affordable_size(const Settings&, const std::vector<Light>&, double budget_ms) const;

 private:
  double ns_per_unit_;
  double ns_per_pixel_;  // all passes but lighting
};

}  // namespace gbl
