// Two words: base colour of 3 x 10 bits, roughness 14, metal 10, occlusion 10.
uvec2 exact_words(Surface s) {
  vec3 c = coded_from_linear(base_of(s));
  uint rough = bits_of(s.roughness, 14);
  return uvec2(bits_of(c.r, 10) | bits_of(c.g, 10) << 10 | bits_of(c.b, 10) << 20 | rough << 30,
               rough >> 2 | bits_of(s.metal, 10) << 12 | bits_of(s.occlusion, 10) << 22);
}

void unpack_exact(uvec2 words, inout Surface s) {
  set_roughness(s, float((words.y & 4095u) << 2 | words.x >> 30) / 16383.0);
  s.metal = float_of(words.y, 12, 10);
  s.occlusion = float_of(words.y, 22, 10);
  set_base(s, linear_from_coded(vec3(float_of(words.x, 0, 10), float_of(words.x, 10, 10), float_of(words.x, 20, 10))));
  s.ambient = ambient_of(s);
}

// Three numbers 0..1 in a word.
uint word_11_11_10(vec3 c) { return bits_of(c.r, 11) | bits_of(c.g, 11) << 11 | bits_of(c.b, 10) << 22; }
vec3 of_word_11_11_10(uint word) { return vec3(float_of(word, 0, 11), float_of(word, 11, 11), float_of(word, 22, 10)); }
