// Deferred lighting's second time over the geometry: the material meets the light that is already summed.
#include "material.glsl"

uniform sampler2D light_diffuse;
uniform sampler2D light_specular;
layout(location = 0) out vec4 lit;

void main() {
  place_surface();
  vec4 base = material_base();
#if ALPHA_MASK
  if (base.a < alpha_cutoff) discard;
#endif
  Surface s = material_surface(base);
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec3 light = s.albedo * texelFetch(light_diffuse, texel, 0).rgb + texelFetch(light_specular, texel, 0).rgb;
  lit = vec4(shading.z * s.ambient + s.emissive + light * light_scale.y, 1.0);
}
