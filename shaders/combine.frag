// Ambient, light sums and albedo to radiance: linear, unclamped. a = 1 where a surface is.
#include "gbuffer_read.glsl"

#if !BACKGROUND_ONLY
#if SPLIT
uniform sampler2D light_diffuse;
uniform sampler2D light_specular;
#else
uniform sampler2D light_sum;
#endif
#endif
layout(location = 0) out vec4 lit;

vec3 background_radiance(vec2 ndc) {
#if SKY
  // A clear day, from horizon to zenith; below the horizon the ground's haze. All rays of an orthographic camera are
  // parallel.
  vec3 direction = normalize(ray_forward.xyz + (1.0 - ray_forward.w) * (ndc.x * ray_right.xyz + ndc.y * ray_up.xyz));
  float height = direction.y;
  if (height < 0.0) return mix(vec3(0.42, 0.45, 0.47), vec3(0.16, 0.15, 0.14), min(-4.0 * height, 1.0));
  return mix(vec3(0.62, 0.74, 0.86), vec3(0.10, 0.24, 0.55), pow(height, 0.6));
#else
  return background.rgb;
#endif
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
#if BACKGROUND_ONLY
  lit = vec4(background_radiance(ndc_of_pixel(gl_FragCoord.xy)), 0.0);
#else
  Surface s = read_surface(texel);
  if (!s.present) {
    lit = vec4(background_radiance(ndc_of_pixel(gl_FragCoord.xy)), 0.0);
    return;
  }
#if SPLIT
  vec3 light = s.albedo * texelFetch(light_diffuse, texel, 0).rgb + texelFetch(light_specular, texel, 0).rgb;
#else
  vec3 light = texelFetch(light_sum, texel, 0).rgb;
#endif
  lit = vec4(shading.z * s.ambient + s.emissive + light * light_scale.y, 1.0);
#endif
}
