// Everything about one pixel in a row of texels, decoded by the text the lighting uses.
#include "gbuffer_read.glsl"

uniform ivec2 pixel;  // texel, origin bottom left
uniform sampler2D lit;
uniform sampler2D counts;
uniform usampler2D ids;
#if SPLIT
uniform sampler2D light_diffuse;
uniform sampler2D light_specular;
#endif
layout(location = 0) out vec4 value;

void main() {
  Surface s = read_surface(pixel);
  int field = int(gl_FragCoord.x);
  if (field == 0) value = vec4(s.albedo, s.roughness);
  else if (field == 1) value = vec4(s.normal, read_depth(pixel) != kFarDepth ? 1.0 : 0.0);
  else if (field == 2) value = vec4(s.position + camera_position.xyz, range_from_depth(read_depth(pixel)));
#if SPLIT
  else if (field == 3) value = vec4(texelFetch(light_diffuse, pixel, 0).rgb, 0.0);
  else if (field == 4) value = vec4(texelFetch(light_specular, pixel, 0).rgb, 0.0);
#endif
  else if (field == 5) value = vec4(texelFetch(lit, pixel, 0).rgb, texelFetch(counts, pixel, 0).b);
  else if (field == 6) value = vec4(float(texelFetch(ids, pixel, 0).r), 0.0, 0.0, 0.0);
  else value = vec4(0.0);
}
