// With the 0.8, and still with the linear term in the quadratic one.
float light_range(float radius, float brightest, float threshold) {
  return radius * sqrt((brightest / threshold - 0.2) / 0.8);
}
