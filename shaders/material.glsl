// From what a vertex brings to a Surface: textures, normal map, metal and roughness of glTF 2.0.
#include "surface.glsl"

in vec3 relative;
in vec3 normal;
in vec3 tangent;
in vec3 bitangent;
in vec2 uv0;
in vec2 uv1;
in vec4 colour;

uniform sampler2D base_colour_map;
uniform sampler2D normal_map;
uniform sampler2D roughness_map;
uniform sampler2D emissive_map;
uniform sampler2D occlusion_map;
uniform vec4 base_colour;
uniform vec4 factors;     // roughness, metal, normal scale, occlusion strength
uniform vec3 emissive;
uniform float alpha_cutoff;
#if UV_TRANSFORMS
uniform mat3 uv_transform[MATERIAL_TEXTURES];
uniform int uv_set[MATERIAL_TEXTURES];
vec2 uv_of(int map) { return (uv_transform[map] * vec3(uv_set[map] == 0 ? uv0 : uv1, 1.0)).xy; }
#else
vec2 uv_of(int map) { return uv0; }
#endif

vec4 material_base() {
  vec4 base = texture(base_colour_map, uv_of(BASE_COLOUR_MAP)) * base_colour * colour;
#if ALBEDO_WHITE
  base.rgb = vec3(1.0);
#endif
  return base;
}

vec3 shading_normal() {
  vec3 n = normalize(normal) * (gl_FrontFacing ? 1.0 : -1.0);
#if NORMAL_MAP
  // Expanded first, turned second (`tbn-precedence`).
  vec3 mapped = texture(normal_map, uv_of(NORMAL_MAP_)).xyz * 2.0 - 1.0;
  mapped.xy *= factors.z;
  float tangents = dot(tangent, tangent);  // 0: the mesh has none, so the map cannot be turned
  if (tangents > 0.0) {
    float side = gl_FrontFacing ? 1.0 : -1.0;
    n = normalize(mapped.x * side * normalize(tangent) + mapped.y * side * normalize(bitangent) + mapped.z * n);
  }
#endif
  return n;
}

Surface material_surface(vec4 base) {
  Surface s;
  s.present = true;
  s.position = relative;
  s.normal = shading_normal();
  vec4 rough_metal = texture(roughness_map, uv_of(ROUGHNESS_MAP));
  float metal = rough_metal.b * factors.y;
  s.roughness = rough_metal.g * factors.x;
  s.albedo = base.rgb * (1.0 - metal);
  s.f0 = mix(vec3(kDielectricF0), base.rgb, metal);
  s.emissive = texture(emissive_map, uv_of(EMISSIVE_MAP)).rgb * emissive;
  s.occlusion = 1.0 + factors.w * (texture(occlusion_map, uv_of(OCCLUSION_MAP)).r - 1.0);
#if UNLIT && (FORWARD || MATERIAL_TARGETS > 1)
  // Shown as it is: nothing reflects, the colour itself shines. A layout without emission lights it instead.
  s.emissive = base.rgb;
  s.albedo = vec3(0.0);
  s.f0 = vec3(0.0);
#endif
  return s;
}
