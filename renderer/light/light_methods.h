#pragma once
// The lighting methods as data. How each draws stands in renderer/passes/lighting.h. Rows: light_methods.inc.
#include "renderer/rows/value_row.h"

namespace gbl {

enum class LightMethod {
#define METHOD(name, ...) name,
#include "renderer/light/light_methods.inc"
#undef METHOD
};

// How a method spreads its work over passes; decides which attachments there are.
enum class Shading { deferred, forward, light_prepass };

struct LightMethodRow {
  ValueRow axis;
  Shading shading = Shading::deferred;
  bool draws_chosen_faces = false;  // those faces of the lights' volumes that lights.cull, .clip and .depth choose
  bool draws_meshes = false;        // of lights.volume.level and .fit
  bool compares_depth = false;      // whatever lights.volume.depth says
  bool marks_stencil = false;
  bool reads_pixels_once = false;  // all of a pixel's light comes from one run of its shader, and none is blended
};
const LightMethodRow& facts(LightMethod);

inline Shading shading_of(LightMethod m) { return facts(m).shading; }
inline bool draws_chosen_faces(LightMethod m) { return facts(m).draws_chosen_faces; }

}  // namespace gbl
