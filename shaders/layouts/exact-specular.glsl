// As exact, a word of emission, and a word of what the surface reflects where it is no metal.
#include "exact_words.glsl"

Stored pack_material(Surface s) {
  Stored t;
  t.material = uvec4(exact_words(s), 0u, 0u);
  t.reflectance = uvec4(word_11_11_10(coded_from_linear(dielectric_of(s))), 0u, 0u, 0u);
  t.emission = uvec4(word_11_11_10(shown_emission(s)), 0u, 0u, 0u);
  return t;
}

void unpack_material(Stored t, inout Surface s) {
  s.f0 = linear_from_coded(of_word_11_11_10(t.reflectance.x));
  unpack_exact(t.material.xy, s);
  s.emissive = emission_of_shown(of_word_11_11_10(t.emission.x));
}
