// One picture per view, for the eye: display-coded RGBA8. RAW shows the stored codes undecoded.
#include "gbuffer_read.glsl"

// Views show where the depth says a surface is, whatever the lighting takes for one.
bool shown_present(ivec2 texel) { return read_depth(texel) != kFarDepth; }

uniform sampler2D lit;
uniform sampler2D counts;
#if SPLIT
uniform sampler2D light_diffuse;
uniform sampler2D light_specular;
#endif
uniform vec3 sky_colour;          // where no surface is
uniform int wasted_from[6];       // the number from which each colour stands
uniform vec3 count_palette[6];    // 0, 1, 2, 3, 4, 5 and more
layout(location = 0) out vec4 picture;

vec3 shown_surface(Surface s, ivec2 texel) {
#if VIEW == VIEW_ALBEDO
  return coded_from_linear(s.albedo);
#elif VIEW == VIEW_NORMAL
  return s.normal * 0.5 + 0.5;
#elif VIEW == VIEW_DEPTH
  float range = range_from_depth(read_depth(texel));
  return vec3(clamp((range - view_range.x) / (view_range.y - view_range.x), 0.0, 1.0));
#elif VIEW == VIEW_MATERIAL
#if MATERIAL_VIEW == MATERIAL_VIEW_ROUGHNESS
  return vec3(s.roughness);
#else
  return clamp(s.f0, 0.0, 1.0);
#endif
#elif VIEW == VIEW_DIFFUSE_LIGHT && SPLIT
  return display(texelFetch(light_diffuse, texel, 0).rgb, shading.w);
#elif VIEW == VIEW_SPECULAR_LIGHT && SPLIT
  return display(texelFetch(light_specular, texel, 0).rgb, shading.w);
#elif VIEW == VIEW_WASTED_PAIRS
  vec4 pairs = texelFetch(counts, texel, 0);
  int colour = 0;
  for (int i = 1; i < 6; ++i) colour += int(pairs.g - pairs.b) >= wasted_from[i] ? 1 : 0;
  return count_palette[colour];
#elif VIEW == VIEW_LIGHTS_PER_PIXEL
  return count_palette[int(min(texelFetch(counts, texel, 0).b, 5.0))];
#elif VIEW == VIEW_POSITION
  return fract((s.position + camera_position.xyz) / view_range.z);
#else
  return vec3(0.0);
#endif
}

// Words are shown by three of their bytes.
#ifdef STORED_MATERIAL
#if MATERIAL_WORDS
vec4 raw_texel(uvec4 t) { return vec4(vec3(t.y & 255u, (t.y >> 8) & 255u, (t.y >> 16) & 255u) / 255.0, 1.0); }
#else
vec4 raw_texel(vec4 t) { return t; }
#endif
#endif

vec4 raw(ivec2 texel) {
#if VIEW == VIEW_ALBEDO && defined(STORED_MATERIAL)
  return vec4(raw_texel(texelFetch(gbuffer_material, texel, 0)).rgb, 1.0);
#elif VIEW == VIEW_MATERIAL && defined(STORED_REFLECTANCE) && !MATERIAL_WORDS
  return texelFetch(gbuffer_reflectance, texel, 0);
#elif VIEW == VIEW_MATERIAL && defined(STORED_MATERIAL)
#if MATERIAL_WORDS
  return raw_texel(texelFetch(gbuffer_material, texel, 0));
#else
  return vec4(texelFetch(gbuffer_material, texel, 0).aaa, 1.0);
#endif
#elif VIEW == VIEW_NORMAL && defined(STORED_NORMAL)
  return raw_normal(texelFetch(gbuffer_normal, texel, 0));
#elif VIEW == VIEW_NORMAL && NORMAL_IN_MATERIAL
  return raw_normal(uvec4(stored_normal_word(texelFetch(gbuffer_material, texel, 0)), 0u, 0u, 0u));
#elif VIEW == VIEW_POSITION && defined(STORED_POSITION)
  return vec4(texelFetch(gbuffer_position, texel, 0).rgb, 1.0);
#elif VIEW == VIEW_DEPTH || VIEW == VIEW_POSITION
  return vec4(vec3(read_depth(texel)), 1.0);
#elif VIEW == VIEW_DIFFUSE_LIGHT && SPLIT
  return vec4(texelFetch(light_diffuse, texel, 0).rgb, 1.0);
#elif VIEW == VIEW_SPECULAR_LIGHT && SPLIT
  return vec4(texelFetch(light_specular, texel, 0).rgb, 1.0);
#elif VIEW == VIEW_WASTED_PAIRS
  vec4 pairs = texelFetch(counts, texel, 0);
  return vec4(vec3(pairs.g - pairs.b) / 255.0, 1.0);
#elif VIEW == VIEW_LIGHTS_PER_PIXEL
  return vec4(texelFetch(counts, texel, 0).bbb / 255.0, 1.0);
#else
  return vec4(texelFetch(lit, texel, 0).rgb, 1.0);
#endif
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
#if RAW
  picture = raw(texel);
#elif VIEW == VIEW_FINAL
  picture = vec4(display(texelFetch(lit, texel, 0).rgb, shading.w), 1.0);
#elif VIEW == VIEW_LIT
  picture = vec4(clamp(texelFetch(lit, texel, 0).rgb, 0.0, 1.0), 1.0);
#else
  Surface s = read_surface(texel);
  picture = vec4(shown_present(texel) ? shown_surface(s, texel) : sky_colour, 1.0);
#endif
}
