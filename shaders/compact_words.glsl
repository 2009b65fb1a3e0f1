// Two words: a normal of up to 28 bits, a colour of 9 9 8, roughness 10. Without the normal its bits are 0.
uvec2 compact_words(Surface s, vec3 colour) {
  vec3 c = coded_from_linear(colour);
  uint rough = bits_of(s.roughness, 10);
  uint word = 0u;
#if NORMAL_IN_MATERIAL
  word = normal_word(s.normal);
#endif
  return uvec2(word | (rough >> 6) << 28, bits_of(c.r, 9) | bits_of(c.g, 9) << 9 | bits_of(c.b, 8) << 18 | (rough & 63u) << 26);
}

vec3 colour_of_compact(uvec2 words) {
  return linear_from_coded(vec3(float_of(words.y, 0, 9), float_of(words.y, 9, 9), float_of(words.y, 18, 8)));
}
float roughness_of_compact(uvec2 words) { return float((words.x >> 28) << 6 | words.y >> 26) / 1023.0; }

uint stored_normal_word(uvec4 material) { return material.x & 0x0fffffffu; }
