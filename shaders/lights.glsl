// Light records from a float texture: no limit of a uniform block, no storage buffer needed.
#include "shared.h"

struct Light {
  vec3 position;  // relative to the camera, world axes
  float range;
  vec3 colour;
};

uniform sampler2D light_data;

vec4 light_texel(int k) { return texelFetch(light_data, ivec2(k % LIGHT_TEXTURE_WIDTH, k / LIGHT_TEXTURE_WIDTH), 0); }

Light read_light(int i) {
  vec4 place = light_texel(i * LIGHT_TEXELS);
  return Light(place.xyz, place.w, light_texel(i * LIGHT_TEXELS + 1).rgb);
}
