#pragma once
// All fixed-function state of a pass as one value: nothing leaks in from the pass before.
namespace gbl::gl {

enum class DepthTest { off, less };
enum class Cull { off, back, front };
enum class Blend { off, add, alpha };

struct PassState {
  DepthTest depth = DepthTest::off;
  bool depth_write = false;
  Cull cull = Cull::off;
  Blend blend = Blend::off;
};

void apply(const PassState&);
void apply_cull(Cull);  // the one state that changes per light (source 0's flip)

}  // namespace gbl::gl
