float shown_depth(float depth, float near, float far) {
  float range = near * far / (far - depth * (far - near));
  return (range - near) / (far - near);
}
