// As exact, and a word of emission.
#include "exact_words.glsl"

Stored pack_material(Surface s) {
  Stored t;
  t.material = uvec4(exact_words(s), 0u, 0u);
  vec3 c = shown_emission(s);
  t.emission = uvec4(bits_of(c.r, 11) | bits_of(c.g, 11) << 11 | bits_of(c.b, 10) << 22, 0u, 0u, 0u);
  return t;
}

void unpack_material(Stored t, inout Surface s) {
  unpack_exact(t.material.xy, s);
  uint word = t.emission.x;
  s.emissive = emission_of_shown(vec3(float_of(word, 0, 11), float_of(word, 11, 11), float_of(word, 22, 10)));
}
