// Albedo and roughness, and the normal where it fits.
#include "compact_words.glsl"

Stored pack_material(Surface s) {
  Stored t;
  t.material = uvec4(compact_words(s, s.albedo), 0u, 0u);
  return t;
}

void unpack_material(Stored t, inout Surface s) {
  set_base(s, colour_of_compact(t.material.xy));
  set_roughness(s, roughness_of_compact(t.material.xy));
  s.ambient = ambient_of(s);
}
