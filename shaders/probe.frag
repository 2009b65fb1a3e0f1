// Everything about one pixel in a row of texels, decoded by the text the lighting uses.
#include "gbuffer_read.glsl"

uniform ivec2 pixel;  // texel, origin bottom left
uniform sampler2D lit;
uniform sampler2D counts;
uniform usampler2D ids;
#if SPLIT
uniform sampler2D light_diffuse;
uniform sampler2D light_specular;
vec3 stored_diffuse_light() { return texelFetch(light_diffuse, pixel, 0).rgb * light_scale.y; }
vec3 stored_specular_light() { return texelFetch(light_specular, pixel, 0).rgb * light_scale.y; }
#else
vec3 stored_diffuse_light() { return vec3(0.0); }
vec3 stored_specular_light() { return vec3(0.0); }
#endif
layout(location = 0) out vec4 value;

vec4 padded(float v) { return vec4(v, 0.0, 0.0, 0.0); }
vec4 padded(vec3 v) { return vec4(v, 0.0); }

void main() {
  Surface s = read_surface(pixel);
  int asked = int(gl_FragCoord.x), field = 0;
  value = vec4(0.0);
#define PROBE_FIELD(name, components, unit, view, read) if (asked == field++) value = padded(read);
#include "probe_fields.h"
}
