// The number of the object that is seen, from 1.
#include "material.glsl"

layout(location = 0) out uvec4 id;

void main() {
  place_surface();
#if ALPHA_MASK
  if (material_base().a < alpha_cutoff) discard;
#endif
  id = uvec4(object_id, 0u, 0u, 0u);
}
