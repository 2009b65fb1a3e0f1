// As the source has it.
float light_range(float radius, float brightest, float threshold) { return radius * sqrt(brightest / threshold - 0.2); }
