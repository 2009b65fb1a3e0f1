#pragma once
// lights.method=auto: which method a frame is drawn with, and why.
#include <string>
#include <vector>

#include "renderer/frame/estimate.h"

namespace gbl {

struct MethodChoice {
  LightMethod method;
  std::string reason;  // empty if the method was asked for by name
};

// The sound and available method with the least estimated work, among those that need no other targets; or the one
// asked for by name. Never auto.
MethodChoice choose_method(const Settings&, const std::vector<Light>&, FeatureSet);

}  // namespace gbl
