// Ambient, light sums and albedo to radiance: linear, unclamped. a = 1 where a surface is.
#include "gbuffer_read.glsl"
#include "background.glsl"

#if !BACKGROUND_ONLY
#if SPLIT
uniform sampler2D light_diffuse;
uniform sampler2D light_specular;
#else
uniform sampler2D light_sum;
#endif
#endif
layout(location = 0) out vec4 lit;

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
