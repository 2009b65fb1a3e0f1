float side(float x) { return x < 0.0 ? -1.0 : 1.0; }

vec3 decode_octahedral(vec2 p) {
  vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
  if (n.z < 0.0) n.xy = vec2((1.0 - abs(p.y)) * side(p.x), (1.0 - abs(p.x)) * side(p.y));
  return normalize(n);
}
