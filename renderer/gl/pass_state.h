#pragma once
// All fixed-function state of a pass as one value: nothing leaks in from the pass before.
namespace gbl::gl {

enum class DepthTest { off, less, less_equal, equal, greater, greater_equal };
enum class Cull { off, back, front };
enum class Blend { off, add, add_colour, alpha };  // add_colour: alpha stays
enum class Winding { counter_clockwise, clockwise };

// What a draw does with the stencil buffer.
enum class Stencil {
  off,
  mark_surface,   // bit 7 is set where something is drawn
  only_surfaces,  // draws where bit 7 is set
  // The other seven bits:
  count_hidden,  // +1 where a back face fails the depth test, -1 where a front face does: left over is what is inside
  take_marked    // draws where it is not 0, and sets it to 0
};

struct PassState {
  DepthTest depth = DepthTest::off;
  bool depth_write = false;
  bool colour_write = true;
  Cull cull = Cull::off;
  Blend blend = Blend::off;
  bool depth_clamp = false;  // needs Feature::depth_clamp
  bool zero_to_one = false;  // clip space's depth, for reversed depth: needs Feature::clip_control
  Stencil stencil = Stencil::off;
};

void apply(const PassState&);   // everything, at the start of a pass
void change(const PassState&);  // between the draws of a pass that was begun with apply()
void apply_cull(Cull);          // changes per light (source 0's flip) and per material (double-sided)
void let_shaders_size_points(bool);
void clip_at_plane(bool);     // by gl_ClipDistance[0]; without it shaders discard (material.glsl)
void apply_winding(Winding);  // of front faces: clockwise where an object is mirrored

}  // namespace gbl::gl
