#pragma once
// All fixed-function state of a pass as one value: nothing leaks in from the pass before.
namespace gbl::gl {

enum class DepthTest { off, less, less_equal, equal, greater, greater_equal };
enum class Cull { off, back, front };
enum class Blend { off, add, add_colour, alpha };  // add_colour: alpha stays
enum class Winding { counter_clockwise, clockwise };

struct PassState {
  DepthTest depth = DepthTest::off;
  bool depth_write = false;
  bool colour_write = true;
  Cull cull = Cull::off;
  Blend blend = Blend::off;
  bool depth_clamp = false;  // needs Feature::depth_clamp
  bool zero_to_one = false;  // clip space's depth, for reversed depth: needs Feature::clip_control
};

void apply(const PassState&);
void apply_cull(Cull);        // changes per light (source 0's flip) and per material (double-sided)
void apply_winding(Winding);  // of front faces: clockwise where an object is mirrored

}  // namespace gbl::gl
