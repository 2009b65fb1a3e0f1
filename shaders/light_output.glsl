// What a lighting pass writes: diffuse and specular apart, their sum, or counts instead of light.
// One place for all methods: a method only says which pairs it tests and shades.
#include "gbuffer_read.glsl"
#include "shade.glsl"
#include "background.glsl"

#ifdef COMPUTE
#include "light_images.glsl"
#elif OUTPUT == OUTPUT_SPLIT
layout(location = 0) out vec4 out_diffuse;
layout(location = 1) out vec4 out_specular;
void add_diffuse(vec3 light) { out_diffuse = vec4(light, 0.0); }
void add_specular(vec3 light) { out_specular = vec4(light, 0.0); }
#elif OUTPUT == OUTPUT_LIT
layout(location = 0) out vec4 lit;  // as combine.frag writes it
#else
layout(location = 0) out vec4 out_sum;
void add_sum(vec3 sum) { out_sum = vec4(sum, 0.0); }
#endif

struct Sums {
  Lighting light;
  vec3 counts;  // pairs tested, pairs shaded, pairs shaded that the light reaches
};

// The pixel as it is left where no surface is: of a sum or a count that is nothing.
#if OUTPUT == OUTPUT_LIT
void write_background() { lit = vec4(background_radiance(ndc_of_pixel(gl_FragCoord.xy)), 0.0); }
#elif !defined(COMPUTE)
void write_background() { discard; }
#endif

Sums no_sums() { return Sums(Lighting(vec3(0.0), vec3(0.0)), vec3(0.0)); }

void add_light(Receiver r, Light light, inout Sums sums) {
#if OUTPUT == OUTPUT_COUNT
  sums.counts.y += 1.0;
  if (reaches(light, r.position)) sums.counts.z += 1.0;
#else
  Lighting one = shade(r, light);
  sums.light.diffuse += one.diffuse;
  sums.light.specular += one.specular;
#endif
}

void write_sums(Surface s, Receiver r, Sums sums) {
  sums.light.specular *= highlight_scale(r);
#if OUTPUT == OUTPUT_SPLIT
  add_diffuse(sums.light.diffuse);
  add_specular(sums.light.specular);
#elif OUTPUT == OUTPUT_LIT
  vec3 light = s.albedo * sums.light.diffuse + sums.light.specular;
  lit = vec4(shading.z * s.ambient + s.emissive + light * light_scale.y, 1.0);
#elif OUTPUT == OUTPUT_SUM
  add_sum(s.albedo * sums.light.diffuse + sums.light.specular);
#else
  add_sum(sums.counts);
#endif
}
