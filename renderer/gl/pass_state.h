#pragma once
// All fixed-function state of a pass as one value: nothing leaks in from the pass before.
namespace gbl::gl {

enum class DepthTest { off, less, less_equal, equal, greater, greater_equal };
enum class Cull { off, back, front };
enum class Blend { off, add, alpha };
enum class Winding { counter_clockwise, clockwise };

// What a draw does with the stencil buffer.
enum class Stencil {
  off,
  count_hidden,  // +1 where a back face fails the depth test, -1 where a front face does: left over is what is inside
  take_marked    // draws where it is not 0, and sets it to 0
};

// Comparisons of distances, for depth that runs from 0 near to 1 far, or reversed from 1 near to 0 far.
constexpr DepthTest nearer_or_equal(bool reversed) {
  return reversed ? DepthTest::greater_equal : DepthTest::less_equal;
}
constexpr DepthTest farther_or_equal(bool reversed) { return nearer_or_equal(!reversed); }

struct PassState {
  DepthTest depth = DepthTest::off;
  bool depth_write = false;
  Cull cull = Cull::off;
  Blend blend = Blend::off;
  bool depth_clamp = false;  // needs Feature::depth_clamp
  bool zero_to_one = false;  // clip space's depth, for reversed depth: needs Feature::clip_control
  Stencil stencil = Stencil::off;
  bool colour_write = true;
};

void apply(const PassState&);   // everything, at the start of a pass
void change(const PassState&);  // between the draws of a pass that was begun with apply()
void apply_cull(Cull);          // changes per light (source 0's flip) and per material (double-sided)
void apply_winding(Winding);    // of front faces: clockwise where an object is mirrored

}  // namespace gbl::gl
