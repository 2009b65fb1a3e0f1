// One picture per view, for the eye: display-coded RGBA8. VIEW_FILE is the view's own file:
//   vec4 shown(ivec2 texel)   as it is looked at
//   vec4 raw(ivec2 texel)     the stored codes, undecoded
// What it may read is declared here and in gbuffer_read.glsl.
#include "gbuffer_read.glsl"

uniform sampler2D lit;
uniform sampler2D counts;         // pairs tested, shaded, in range
#if SPLIT
uniform sampler2D light_diffuse;
uniform sampler2D light_specular;
#endif
uniform vec3 empty_colour;        // where no surface is
uniform int wasted_from[6];       // the number from which each colour stands
uniform vec3 count_palette[6];    // 0, 1, 2, 3, 4, 5 and more
layout(location = 0) out vec4 picture;

// Views show where the depth says a surface is, whatever the lighting takes for one.
vec4 on_surfaces(ivec2 texel, vec3 colour) {
  return vec4(read_depth(texel) != kFarDepth ? colour : empty_colour, 1.0);
}

// What stands for codes that are not stored.
vec4 raw_lit(ivec2 texel) { return vec4(texelFetch(lit, texel, 0).rgb, 1.0); }

// Words are shown by three of their bytes.
#ifdef STORED_MATERIAL
#if MATERIAL_WORDS
vec4 raw_texel(uvec4 t) { return vec4(vec3(t.y & 255u, (t.y >> 8) & 255u, (t.y >> 16) & 255u) / 255.0, 1.0); }
#else
vec4 raw_texel(vec4 t) { return t; }
#endif
#endif

#include VIEW_FILE

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
#if RAW
  picture = raw(texel);
#else
  picture = shown(texel);
#endif
}
