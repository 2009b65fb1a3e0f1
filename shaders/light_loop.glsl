// What loops over lights, after the G-buffer is read.
#define LOOPS_OVER_LIGHTS (OUTPUT != OUTPUT_COUNT)
#include "light_output.glsl"

// Lights that a method has read: tested, and shaded if any of them reaches the surface.
void test_and_add(Receiver r, Light some, inout Sums sums) {
  sums.counts.x += 1.0;
  if (reaches(some, r.position)) add_light(r, some, sums);
}
