float light_range(float radius, float brightest, float threshold) {
  float c = 0.2 - brightest / threshold;
  return radius * (-0.4 + sqrt(0.16 - 1.6 * c)) / 0.8;
}
