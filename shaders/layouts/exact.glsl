// Base colour, roughness, metal and occlusion.
#include "exact_words.glsl"

Stored pack_material(Surface s) {
  Stored t;
  t.material = uvec4(exact_words(s), 0u, 0u);
  return t;
}

void unpack_material(Stored t, inout Surface s) { unpack_exact(t.material.xy, s); }
