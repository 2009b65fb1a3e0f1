// Surfaces shaded as they are drawn: opaque ones of forward shading, and transparent ones after any lighting.
// A span of lights per draw: all of them, or one and added up. OUTPUT_COUNT counts pairs instead.
#define LOOPS_OVER_LIGHTS (OUTPUT != OUTPUT_COUNT && !ONE_LIGHT)
#include "material.glsl"
#include "shade.glsl"

uniform ivec2 light_span;     // from, to: all, one or none
uniform float ambient_share;  // 1 in the draw that brings ambient light and emission
layout(location = 0) out vec4 radiance;

void add(Lighting some, inout Lighting all) {
  all.diffuse += some.diffuse;
  all.specular += some.specular;
}

void main() {
  place_surface();
  vec4 base = material_base();
#if ALPHA_MASK
  if (base.a < alpha_cutoff) discard;
#endif
#if OUTPUT == OUTPUT_COUNT
  vec3 counts = vec3(0.0);
  for (int i = light_span.x; i < light_span.y; ++i) counts += vec3(1.0, 1.0, reaches(read_light(i), sunk_position) ? 1.0 : 0.0);
  radiance = vec4(counts, 0.0);
#else
  Surface s = material_surface(base);
  vec3 sum = vec3(0.0);
#if !UNLIT
  Receiver r = receiver_of(s);
  Lighting all = Lighting(vec3(0.0), vec3(0.0));
#if LIGHTS_AT_ONCE == 4
  ivec2 fours = light_span.y > 0 ? light_fours() : ivec2(0);
  for (int i = 0; i < fours.x; ++i) add(shade(r, read_plain_four(i)), all);
#if MIXED_LIGHTS
  for (int i = fours.x; i < fours.y; ++i) add(shade(r, read_four(i)), all);
#endif
#else
  for (int i = light_span.x; i < light_span.y; ++i) add(shade(r, read_light(i)), all);
#endif
  sum = s.albedo * all.diffuse + highlight_scale(r) * all.specular;
#endif
  sum = ambient_share * (shading.z * s.ambient + s.emissive) + sum * light_scale.y;
#if BLENDED
  radiance = vec4(sum, base.a);
#else
  radiance = vec4(sum, 1.0);
#endif
#endif
}
