// Colour coding: IEC 61966-2-1:1999 (sRGB). Under COLOUR_AS_TUTORIAL codes are used as if they were linear.
vec3 srgb_from_linear(vec3 c) {
  return mix(12.92 * c, 1.055 * pow(max(c, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055, step(vec3(0.0031308), c));
}
vec3 linear_from_srgb(vec3 c) {
  return mix(c / 12.92, pow((max(c, vec3(0.04045)) + 0.055) / 1.055, vec3(2.4)), step(vec3(0.04045), c));
}

#if COLOUR == COLOUR_SRGB
vec3 coded_from_linear(vec3 c) { return srgb_from_linear(clamp(c, 0.0, 1.0)); }
vec3 linear_from_coded(vec3 c) { return linear_from_srgb(c); }
#else
vec3 coded_from_linear(vec3 c) { return clamp(c, 0.0, 1.0); }
vec3 linear_from_coded(vec3 c) { return c; }
#endif

// The nearest code of 8 bits, rounded here and not by the driver's store.
vec3 quantised8(vec3 c) { return floor(clamp(c, 0.0, 1.0) * 255.0 + 0.5) / 255.0; }
vec4 quantised8(vec4 c) { return floor(clamp(c, 0.0, 1.0) * 255.0 + 0.5) / 255.0; }

// What the display shows: exposure, clamp, transfer curve.
vec3 display(vec3 radiance, float exposure) { return coded_from_linear(clamp(radiance * exposure, 0.0, 1.0)); }
