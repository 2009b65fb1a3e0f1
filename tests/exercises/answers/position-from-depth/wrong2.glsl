// Looks along +z.
vec3 view_position(vec2 ndc, float depth, vec2 tan_half, float near, float far) {
  float range = near * far / (far - depth * (far - near));
  return vec3(ndc * tan_half, 1.0) * range;
}
