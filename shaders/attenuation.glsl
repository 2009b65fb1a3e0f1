// How much of a light arrives, by distance. In the subset common to GLSL and C++ (normal_encoding.glsl says how).

// 1 - x^4, down to 0 where x = 1
lane window_of(lane x) {
  lane x_2 = x * x;
  return clamp(real(1.0) - x_2 * x_2, real(0.0), real(1.0));
}

// `range` is the lights' own, whatever range.kind makes of its end.
lane attenuation(lane d, lane range) {
#if ATTENUATION == ATTENUATION_NONE
  return lane(1.0);
#elif ATTENUATION == ATTENUATION_LINEAR
  return real(1.0) - clamp(d / range, real(0.0), real(1.0));
#elif ATTENUATION == ATTENUATION_QUADRATIC
  return real(1.0) / (real(1.0) + real(0.7) * d + real(1.8) * d * d);
#elif ATTENUATION == ATTENUATION_RAMP
  lane x = real(4.0) * d / range;
  return real(1.0) / max(real(0.2) + real(0.4) * x + real(0.4) * x * x, real(1.0));
#elif ATTENUATION == ATTENUATION_INVERSE_LINEAR
  return real(1.0) / (real(1.0) + real(9.0) * d / range);
#elif ATTENUATION == ATTENUATION_GLTF
  // KHR_lights_punctual, "Range Property"; nearer than 0.1 mm it stops growing.
  return window_of(d / range) / max(d * d, real(1e-8));
#else
  // Karis 2013, "Real Shading in Unreal Engine 4"; nearer than 1 cm it stops growing, or a pixel on a lamp overflows.
  lane window = window_of(d / range);
  return window * window / max(d * d, real(1e-4));
#endif
}
