// Depth is taken for -1 to 1.
float shown_depth(float depth, float near, float far) {
  float range = 2.0 * near * far / (far + near - depth * (far - near));
  return (range - near) / (far - near);
}
