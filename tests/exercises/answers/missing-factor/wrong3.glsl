// The other root.
float light_range(float radius, float brightest, float threshold) {
  return radius * (-0.4 - sqrt(0.16 + 1.6 * (brightest / threshold - 0.2))) / 0.8;
}
