// From what a vertex brings to a Surface: textures, normal map, metal and roughness of glTF 2.0.
#include "surface.glsl"
#include "depth.glsl"

in vec3 relative;
in vec3 normal;
in vec3 tangent;
in vec3 bitangent;
in vec2 uv0;
in vec2 uv1;
in vec4 colour;
flat in uint object_id;  // from 1
flat in mat3 object_axes;

uniform sampler2D base_colour_map;
uniform sampler2D normal_map;
uniform sampler2D roughness_map;
uniform sampler2D emissive_map;
uniform sampler2D occlusion_map;
uniform vec4 base_colour;
uniform vec4 factors;     // roughness, metal, normal scale, occlusion strength
uniform vec3 emissive;
uniform float alpha_cutoff;
#if SPECULAR
uniform sampler2D specular_map;
uniform sampler2D specular_colour_map;
uniform vec4 specular;    // rgb: colour x reflectance of the index over the common one, a: weight
#endif
#if UV_TRANSFORMS
uniform mat3 uv_transform[MATERIAL_TEXTURES];
uniform int uv_set[MATERIAL_TEXTURES];
vec2 uv_of(int map) { return (uv_transform[map] * vec3(uv_set[map] == 0 ? uv0 : uv1, 1.0)).xy; }
#else
vec2 uv_of(int map) { return uv0; }
#endif

// Without planes that clip, pixel by pixel.
#if CLIP_PLANE && !SHADOW_MAP && !HAS_CLIP_DISTANCE
uniform vec4 clip_plane;  // relative to the camera: what is behind it is cut away
void cut_at_plane() {
  if (dot(clip_plane, vec4(relative, 1.0)) < 0.0) discard;
}
#else
void cut_at_plane() {}
#endif

// UVS_MOVED: for the reference, which knows where lines of sight end.
#if PARALLAX || (UVS_MOVED && HEIGHTS)
#include "parallax.glsl"
vec3 sunk_position;
vec2 uv_moved;
vec2 moved_by(int map) {
#if UV_TRANSFORMS
  return uv_set[map] == 0 ? mat2(uv_transform[map]) * uv_moved : vec2(0.0);
#else
  return uv_moved;
#endif
}
// As large as on the flat surface: texture coordinates jump from pixel to pixel where a higher place hides a lower one.
vec4 read_map(sampler2D map, int which) {
  vec2 uv = uv_of(which);
  return textureGrad(map, uv + moved_by(which), dFdx(uv), dFdy(uv));
}

#if SHADOW_MAP
uniform mat4 shadow_clip_from_anchored;
#endif
#if !UVS_MOVED && PARALLAX_DEPTH == PARALLAX_DEPTH_DISPLACED
invariant gl_FragDepth;  // passes of other programs test for this very depth
#endif
// First of all: where the surface is.
void place_surface() {
  cut_at_plane();
  sink(relative, uv0, sunk_position, uv_moved);
#if UVS_MOVED || PARALLAX_DEPTH == PARALLAX_DEPTH_FLAT
  sunk_position = relative;
#elif SHADOW_MAP
  vec4 clip = shadow_clip_from_anchored * vec4(sunk_position, 1.0);
  gl_FragDepth = clip.z / clip.w * 0.5 + 0.5;
#else
  gl_FragDepth = depth_from_range(dot(sunk_position, ray_forward.xyz));
#endif
}
#else
#define sunk_position relative
vec4 read_map(sampler2D map, int which) { return texture(map, uv_of(which)); }
void place_surface() { cut_at_plane(); }
#endif

// Texels of a material that has no such map: nobody reads one that is not there.
#if HAS_BASE_COLOUR_MAP
vec4 base_colour_texel() { return read_map(base_colour_map, BASE_COLOUR_MAP); }
#else
vec4 base_colour_texel() { return vec4(1.0); }
#endif
#if HAS_ROUGHNESS_MAP
vec4 roughness_texel() { return read_map(roughness_map, ROUGHNESS_MAP); }
#else
vec4 roughness_texel() { return vec4(1.0); }
#endif
#if HAS_EMISSIVE_MAP
vec3 emissive_texel() { return read_map(emissive_map, EMISSIVE_MAP).rgb; }
#else
vec3 emissive_texel() { return vec3(1.0); }
#endif
#if HAS_OCCLUSION_MAP
float occlusion() { return 1.0 + factors.w * (read_map(occlusion_map, OCCLUSION_MAP).r - 1.0); }
#else
float occlusion() { return 1.0; }
#endif

#if REFRACTS
uniform vec2 transmission;  // share that goes through, index of the air over that of the material
#endif

#if REFRACTS
// No metal is clear.
float through_share() { return transmission.x * (1.0 - roughness_texel().b * factors.y); }
#endif

vec4 tint() {
  vec4 base = base_colour_texel() * base_colour * colour;
#if ALBEDO_WHITE
  base.rgb = vec3(1.0);
#endif
  return base;
}

vec4 material_base() {
  vec4 base = tint();
#if REFRACTS
  base.rgb *= 1.0 - through_share();  // the rest comes through: reflection.frag
#endif
  return base;
}

#if MISTAKE_INTERPOLATED_NOT_NORMALISED
vec3 unit(vec3 v) { return v; }
#else
vec3 unit(vec3 v) { return normalize(v); }
#endif

vec3 unit_or_zero(vec3 v) { return v * inversesqrt(max(dot(v, v), 1e-30)); }

// Columns: along +u, along +v, along the normal.
mat3 tangent_frame(vec3 n, float side) {
#if TANGENTS == TANGENTS_VERTEX
  return mat3(unit_or_zero(tangent) * side, unit_or_zero(bitangent) * side, n);
#elif TANGENTS == TANGENTS_MATRIX_COLUMNS
  return mat3(normalize(object_axes[0]), normalize(object_axes[1]), n);
#else
  // The frame in which position changes with u and v (Schueler 2006, "Normal Mapping Without Precomputed Tangents").
  vec2 uv = uv_of(NORMAL_MAP_);
  vec3 across = cross(dFdy(relative), n), down = cross(n, dFdx(relative));
  vec2 du = vec2(dFdx(uv.x), dFdy(uv.x)), dv = vec2(dFdx(uv.y), dFdy(uv.y));
  vec3 t = unit_or_zero(across * du.x + down * du.y), b = unit_or_zero(across * dv.x + down * dv.y);
  // v runs downwards, +Y of the map upwards. On a back face the frame is turned with the normal, as glTF asks.
  return mat3(t * side, -b * side, n);
#endif
}

vec3 shading_normal() {
  float side = gl_FrontFacing ? 1.0 : -1.0;
  vec3 n = unit(normal) * side;
#if NORMAL_MAP
  vec3 texel = read_map(normal_map, NORMAL_MAP_).xyz;
  mat3 frame = tangent_frame(n, side);
  if (dot(frame[0], frame[0]) > 0.0) {  // 0: the mesh has no tangents, so the map cannot be turned
#if MISTAKE_TBN_PRECEDENCE
    n = normalize(frame * texel * 2.0 - 1.0);
#else
    // Expanded first, turned second (`tbn-precedence`).
    n = unit(frame * ((texel * 2.0 - 1.0) * vec3(factors.z, factors.z, 1.0)));
#endif
  }
#endif
  return n;
}

// Specular colour texel, and the texel of its weight.
vec4 specular_texel() {
#if SPECULAR
  return vec4(read_map(specular_colour_map, SPECULAR_COLOUR_MAP).rgb, read_map(specular_map, SPECULAR_MAP).a);
#else
  return vec4(1.0);
#endif
}

// KHR_materials_specular: no material reflects more than all; the classic models' factor may make more of that. The
// reflectance at grazing angles follows from it as everywhere (grazing_of() in pair.glsl).
vec3 material_dielectric() {
#if SPECULAR
  vec4 texel = specular_texel();
  vec3 of_common = min(specular.rgb * texel.rgb, vec3(1.0 / kCommonReflectance));
  return dielectric_f0() * of_common * specular.a * texel.a;
#else
  return vec3(dielectric_f0());
#endif
}

Surface material_surface(vec4 base) {
  Surface s;
  s.present = true;
  s.position = sunk_position;
  s.normal = shading_normal();
  vec4 rough_metal = roughness_texel();
  float metal = rough_metal.b * factors.y;
  s.roughness = rough_metal.g * factors.x;
  s.exponent = exponent_of(s.roughness);
  s.metal = metal;
  s.albedo = base.rgb * (1.0 - metal);
  s.f0 = mix(material_dielectric(), base.rgb, metal);
  s.emissive = emissive_texel() * emissive;
  s.occlusion = occlusion();
#if UNLIT && EMISSION_KEPT
  // Shown as it is, whatever the exposure: nothing reflects, the colour itself shines. A layout without emission lights it instead.
  s.emissive = base.rgb / shading.w;
  s.albedo = vec3(0.0);
  s.f0 = vec3(0.0);
  s.metal = 1.0;  // a black metal: no dielectric highlight either
#endif
  s.ambient = ambient_of(s);
  return s;
}
