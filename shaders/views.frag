// One view: a picture for the eye, display-coded RGBA8, or its numbers. VIEW_FILE is the view's own file:
//   vec3 value(ivec2 texel)   its numbers, in its unit
//   vec4 shown(ivec2 texel)   as it is looked at
//   vec4 raw(ivec2 texel)     the stored codes, undecoded
// What it may read is declared here and in gbuffer_read.glsl. VIEW_AS says what is drawn.
#include "gbuffer_read.glsl"
#include "shadow.glsl"

uniform sampler2D lit;
uniform sampler2D counts;         // pairs tested, shaded, in range
uniform sampler2D counts_lit;     // lights whose range reaches the surface
uniform sampler2D redrawn_counts;     // fragments written, culled faces in front
uniform sampler2D redrawn_triangles;  // of the seen one: area in pixels, edge, turned away
uniform usampler2D ids;           // numbers of the objects, from 1
#if SPLIT
uniform sampler2D light_diffuse;
uniform sampler2D light_specular;
#endif
#ifdef STORED_ID
uniform usampler2D gbuffer_id;
#endif
uniform vec3 empty_colour;        // where no surface is
uniform vec2 black_and_white;     // in the view's unit
uniform int count_from[6];        // the number from which each colour stands
uniform vec3 count_palette[6];
uniform vec3 class_colours[6];
uniform int picked_light;          // its index; -1: there is none
uniform vec2 cells_per_pixel;     // of tiles or clusters
layout(location = 0) out vec4 picture;

// Views show where the depth says a surface is, whatever the lighting takes for one.
vec4 on_surfaces(ivec2 texel, vec3 colour) {
  return vec4(read_depth(texel) != kFarDepth ? colour : empty_colour, 1.0);
}

vec3 of_range(vec3 v) { return (v - black_and_white.x) / (black_and_white.y - black_and_white.x); }

vec3 colour_of_count(float count) {
  int colour = 0;
  for (int i = 1; i < 6; ++i) colour += int(count) >= count_from[i] ? 1 : 0;
  return count_palette[colour];
}

vec3 colour_of_class(int number) { return class_colours[clamp(number, 0, 5)]; }

uint object_at(ivec2 texel) {
#ifdef STORED_ID
  return texelFetch(gbuffer_id, texel, 0).r;
#else
  return texelFetch(ids, texel, 0).r;
#endif
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

// Where reflectance, metal and occlusion are kept.
vec4 raw_reflectance(ivec2 texel) {
#ifdef STORED_REFLECTANCE
  return raw_texel(texelFetch(gbuffer_reflectance, texel, 0));
#elif defined(STORED_MATERIAL)
  return raw_texel(texelFetch(gbuffer_material, texel, 0));
#else
  return raw_lit(texel);
#endif
}

#include VIEW_FILE

#if VIEW_AS == VIEW_AS_NUMBERS
uniform ivec4 pixel_grid;  // of the asked pixels: the first texel, the step
void main() {
  ivec2 texel = pixel_grid.xy + ivec2(gl_FragCoord.xy) * pixel_grid.zw;
  picture = vec4(value(texel), BACKGROUND_TOO == 1 || read_depth(texel) != kFarDepth ? 1.0 : 0.0);
}
#elif VIEW_AS == VIEW_AS_LOOK
uniform vec3 look_channels;  // 1 where shown
bool finite(float x) { return abs(x) < 3.0e38; }
#if LOOK_STOPS > 0
uniform vec3 look_stops[LOOK_STOPS];
uniform int look_channel;
vec3 looked_at(vec3 t) {
  float place = clamp(t[look_channel], 0.0, 1.0) * float(LOOK_STOPS - 1);
  int i = min(int(place), LOOK_STOPS - 2);
  return mix(look_stops[i], look_stops[i + 1], place - float(i));
}
#else
vec3 looked_at(vec3 t) {
#if LOOK_CODED
  return look_channels * coded_from_linear(clamp(t, 0.0, 1.0));
#else
  return look_channels * clamp(t, 0.0, 1.0);
#endif
}
#endif
void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec3 v = value(texel);
  vec3 colour = finite(v.x) && finite(v.y) && finite(v.z) ? looked_at(of_range(v)) : vec3(1.0, 0.0, 1.0);
#if BACKGROUND_TOO
  picture = vec4(colour, 1.0);
#else
  picture = on_surfaces(texel, colour);
#endif
}
#elif VIEW_AS == VIEW_AS_OVERLAY
uniform float opacity;
// How much of a pixel an overlay covers: all of what it marks, else every surface. A view's file may say it otherwise.
#ifndef COVERS
#define COVERS(v) (v.x != 0.0 ? 1.0 : 0.0)
#endif
void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  bool there = BACKGROUND_TOO == 1 || read_depth(texel) != kFarDepth;
#if VIEW_MARKS
  vec3 marked = value(texel);
  float covers = COVERS(marked);
#else
  float covers = 1.0;
#endif
  picture = vec4(shown(texel).rgb, there ? covers * opacity : 0.0);
}
#elif VIEW_AS == VIEW_AS_STORED
void main() { picture = raw(ivec2(gl_FragCoord.xy)); }
#else
void main() { picture = shown(ivec2(gl_FragCoord.xy)); }
#endif
