// Material and normal of what is visible, packed as the layout says.
#include "surface.glsl"

in vec3 normal;
in vec3 tangent;
in vec3 bitangent;
in vec2 uv;

uniform sampler2D base_colour_map;
uniform sampler2D normal_map;
uniform sampler2D roughness_map;
uniform vec3 base_colour;
uniform float roughness;

layout(location = 0) out vec4 out_material;
layout(location = 1) out NORMAL_OUTPUT out_normal;

vec3 shading_normal() {
#if NORMAL_MAP
  vec3 mapped = texture(normal_map, uv).xyz * 2.0 - 1.0;  // expanded first, turned second (`tbn-precedence`)
  return normalize(mapped.x * normalize(tangent) + mapped.y * normalize(bitangent) + mapped.z * normalize(normal));
#else
  return normalize(normal);
#endif
}

void main() {
  Surface s;
  s.present = true;
  s.position = vec3(0.0);
  s.normal = shading_normal();
#if ALBEDO_WHITE
  s.albedo = vec3(1.0);
#else
  s.albedo = texture(base_colour_map, uv).rgb * base_colour;
#endif
  s.roughness = texture(roughness_map, uv).g * roughness;
  out_material = pack_material(s);
  out_normal = pack_normal(s.normal);
}
