// Never unfolded.
vec3 decode_octahedral(vec2 p) { return normalize(vec3(p, 1.0 - abs(p.x) - abs(p.y))); }
