// Objects drawn once more, to be counted and measured. REDRAWN says what: the fragments that are written, the triangle that
// is seen, or the faces that were culled.
#include "material.glsl"

layout(location = 0) out vec4 result;
#if REDRAWN == REDRAWN_TRIANGLES
in vec3 corner_by_w;
#endif

void main() {
  place_surface();
#if ALPHA_MASK
  if (material_base().a < alpha_cutoff) discard;
#endif
#if REDRAWN == REDRAWN_WRITTEN
  result = vec4(1.0, 0.0, 0.0, 0.0);
#elif REDRAWN == REDRAWN_CULLED
  result = vec4(0.0, 1.0, 0.0, 0.0);
#else
  vec2 corner = corner_by_w.xy / corner_by_w.z;  // barycentric coordinates on screen: of the second and the third corner
  vec2 dx = dFdx(corner), dy = dFdy(corner);
  vec3 weights = vec3(1.0 - corner.x - corner.y, corner);
  vec3 steps = vec3(length(vec2(dx.x + dx.y, dy.x + dy.y)), length(vec2(dx.x, dy.x)), length(vec2(dx.y, dy.y)));
  vec3 pixels = weights / max(steps, vec3(1.0e-20));  // from each edge
  float nearest = min(pixels.x, min(pixels.y, pixels.z));
  float area = 0.5 / max(abs(dx.x * dy.y - dx.y * dy.x), 1.0e-20);
  result = vec4(area, clamp(1.0 - nearest, 0.0, 1.0), gl_FrontFacing ? 0.0 : 1.0, 0.0);
#endif
}
