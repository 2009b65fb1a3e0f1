// For the reference: which triangle is seen, and what its textures hold there. Nothing is worked out from them here.
#include "material.glsl"

flat in uint triangle;

layout(location = 0) out vec4 seen;      // object from 1, triangle from 0: whole numbers below 2^24; roughness and metal texels
layout(location = 1) out vec4 base;      // base colour texel
layout(location = 2) out vec4 mapped;    // normal map's texel, occlusion texel
layout(location = 3) out vec4 emission;  // emission texel
layout(location = 4) out vec4 shine;     // specular colour's texel, specular weight's texel

void main() {
  place_surface();
#if ALPHA_MASK
  if (material_base().a < alpha_cutoff) discard;
#endif
  vec4 rough_metal = roughness_texel();
  seen = vec4(float(object_id), float(triangle), rough_metal.g, rough_metal.b);
  base = base_colour_texel();
  mapped = vec4(read_map(normal_map, NORMAL_MAP_).xyz, read_map(occlusion_map, OCCLUSION_MAP).r);
  emission = read_map(emissive_map, EMISSIVE_MAP);
  shine = specular_texel();
}
