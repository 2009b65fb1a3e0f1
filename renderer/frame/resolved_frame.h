#pragma once
// ResolvedFrame: what settings mean for a scene on a device, worked out once. Nothing is left to choose. The passes, the
// report and the predictions read it and do not ask the settings again.
#include <memory>
#include <string>
#include <vector>

#include "renderer/frame/attachments.h"
#include "renderer/light/shadow_maps.h"
#include "renderer/reflection/mirrors.h"
#include "renderer/scene/scene.h"

namespace gbl {

struct ResolvedFrame {
  Settings settings;                 // with a layout and a method; `view` has no part in it
  std::vector<std::string> choices;  // what was chosen for `auto` and why, a sentence each
  std::string method_reason;         // why lights.method=auto chose the method; empty if it was asked for by name

  std::vector<Light> lights;
  int light_total = 0;                   // of which lights.only chose one
  bool light_kinds = false;              // is any light other than a plain point light?
  std::vector<uint32_t> special_lights;  // all but plain point lights without a shadow
  bool many_lights = false;              // a pixel reads more than a few of them
  double light_work = 0;  // of the lighting pass, in turns of the full-screen loop (renderer/frame/estimate.h)

  std::vector<Attachment> attachments;
  int gbuffer_bytes_per_pixel = 0, accumulation_bytes_per_pixel = 0;
  Shading shading = Shading::deferred;
  bool split = false;               // diffuse and specular light are kept apart
  bool folds_light = false;         // the light pass finishes the picture: there are no sums
  bool light_sum_is_begun = false;  // the sum of light holds ambient and emission before lighting begins
  bool normal_in_material = false;  // both share one attachment
  bool stencil = false;             // a pass marks pixels
  bool lighting_tests_depth = false;
  bool lighting_has_depth = false;  // it, or the stencil beside it
  bool multisampled = false;
  double volume_depth_step = 0;   // window depth that rounding can hide between a surface and a volume's face
  bool transparent_pass = false;  // something is drawn forward after the lighting

  ShadowPlan shadows;           // no maps: no light has a shadow
  std::vector<Mirror> mirrors;  // that show the scene; flat ones only where planes are drawn

  std::vector<int> tessellated;  // objects, from 0, that are drawn as triangles made from their height maps

  double light_sum_scale = 1;  // light sums are stored times this power of two

  double aspect = 1;  // width over height
  DepthRuns depth_runs = DepthRuns::standard;
  glm::dmat4 clip_from_relative{1};  // relative to the camera, world axes

  bool mistaken(Mistake m) const { return settings.mistakes.count(m) > 0; }
};

// Into how many a triangle is cut at most, if each of its edges is cut into so many pieces: rings of n, n - 2, ... pieces, a triangle
// for each piece on both sides (OpenGL 4.6, section 11.2.2.1).
inline long long tessellated_triangles(int level) { return (3LL * level * level + 1) / 2; }
inline constexpr long long kMostTessellated = 1'000'000;  // of a frame: 216 bytes each

ResolvedFrame resolve_frame(const Settings&, const Scene&, FeatureSet);

// The frames resolved last: one is worked out anew only when its settings, its scene or its rig's file have changed.
class Resolver {
 public:
  // The scene is not kept alive.
  std::shared_ptr<const ResolvedFrame> get(const Settings&, const std::shared_ptr<const Scene>&, FeatureSet);
  int resolved() const { return resolved_; }  // how many were worked out

 private:
  struct Entry {
    Settings settings;  // as asked for
    std::weak_ptr<const Scene> scene;
    FeatureSet features;
    long long rig_stamp = 0;
    std::shared_ptr<const ResolvedFrame> frame;
  };
  std::vector<Entry> entries_;  // the latest first
  int resolved_ = 0;
};

}  // namespace gbl
