// What becomes of the picked light: 0 outside, 1 covered and out of range, 2 lit, 3 missed, 4 shaded too often.
vec3 value(ivec2 texel) {
  vec3 pairs = texelFetch(counts, texel, 0).xyz;  // of this light alone
  bool reached = texelFetch(counts_lit, texel, 0).r > 0.5;
  if (!reached) return vec3(pairs.y > 0.5 ? 1.0 : 0.0);
  return vec3(pairs.z < 0.5 ? 3.0 : pairs.z > 1.5 ? 4.0 : 2.0);
}

vec4 shown(ivec2 texel) { return on_surfaces(texel, colour_of_class(int(value(texel).x))); }

vec4 raw(ivec2 texel) { return vec4(value(texel) / 255.0, 1.0); }
