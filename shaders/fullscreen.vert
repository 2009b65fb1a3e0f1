// One triangle over the whole viewport, from gl_VertexID alone.
#if VARYING_INVERSE
#include "shared.h"
#endif
#include "varyings.glsl"

void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
  pass_varyings();
}
