// Depth and nothing else; masked surfaces leave out what the geometry pass would.
#include "material.glsl"

void main() {
  place_surface();
#if ALPHA_MASK && !SHADOW_SOLID
  if (material_base().a < alpha_cutoff) discard;
#endif
}
