// As exact, and a word of emission.
#include "exact_words.glsl"

Stored pack_material(Surface s) {
  Stored t;
  t.material = uvec4(exact_words(s), 0u, 0u);
  t.emission = uvec4(word_11_11_10(shown_emission(s)), 0u, 0u, 0u);
  return t;
}

void unpack_material(Stored t, inout Surface s) {
  unpack_exact(t.material.xy, s);
  s.emissive = emission_of_shown(of_word_11_11_10(t.emission.x));
}
