// As compact, with the base colour, and a word whose bit 31 says which of two ways its other bits are shared out.
#include "compact_words.glsl"

Stored pack_material(Surface s) {
  Stored t;
  t.material = uvec4(compact_words(s, base_of(s)), 0u, 0u);
  vec3 c = shown_emission(s);
  uvec3 e = uvec3(bits_of(c.r, 8), bits_of(c.g, 8), bits_of(c.b, 8));
  if ((e.r | e.g | e.b) == 0u)
    t.reflectance = uvec4(bits_of(s.metal, 10) | bits_of(s.occlusion, 10) << 10, 0u, 0u, 0u);
  else
    t.reflectance = uvec4(e.r | e.g << 8 | e.b << 16 | bits_of(s.metal, 3) << 24 | bits_of(s.occlusion, 4) << 27 | 0x80000000u, 0u, 0u, 0u);
  return t;
}

void unpack_material(Stored t, inout Surface s) {
  uint word = t.reflectance.x;
  bool shines = word >> 31 == 1u;
  s.metal = shines ? float_of(word, 24, 3) : float_of(word, 0, 10);
  s.occlusion = shines ? float_of(word, 27, 4) : float_of(word, 10, 10);
  if (shines) s.emissive = emission_of_shown(vec3(float_of(word, 0, 8), float_of(word, 8, 8), float_of(word, 16, 8)));
  set_base(s, colour_of_compact(t.material.xy));
  set_roughness(s, roughness_of_compact(t.material.xy));
  s.ambient = ambient_of(s);
}
