#pragma once
// Choices that are left to the lab: `auto` becomes the value that this scene needs, before anything is drawn.
#include <string>
#include <vector>

#include "renderer/options/settings.h"
#include "renderer/scene/scene.h"

namespace gbl {

// What the opaque materials of a scene need stored besides albedo and roughness.
struct MaterialNeeds {
  bool metal = false, emission = false, occlusion = false;
  bool specular = false;  // a reflectance of their own where they are no metal
  bool any() const { return metal || emission || occlusion || specular; }
  bool has(MaterialHas) const;
};
// refraction: are clear materials stored, too?
MaterialNeeds needs_of(const Scene&, bool refraction = false);

// The smallest layout that holds these needs, and what it leaves out, a sentence each.
struct LayoutChoice {
  Layout layout;
  std::vector<std::string> left_out;
};
LayoutChoice choose_layout(const MaterialNeeds&);

struct Resolved {
  Settings settings;               // with no layout left to choose
  std::vector<std::string> notes;  // what was chosen and why, a sentence each
};
Resolved resolve(const Settings&, const Scene&);

// depth.format=auto becomes what this device has; what was chosen is noted. Where depth cannot be reversed the near
// plane moves out to just before the scene: nothing that is drawn lies nearer, and depth's steps grow with 1/near.
void choose_depth(Resolved&, const Scene&, FeatureSet);

}  // namespace gbl
