// Depth taken for a distance between the planes.
vec3 view_position(vec2 ndc, float depth, vec2 tan_half, float near, float far) {
  return vec3(ndc * tan_half, -1.0) * mix(near, far, depth);
}
