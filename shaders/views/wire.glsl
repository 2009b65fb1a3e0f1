// How much of the pixel the nearest edge of its triangle covers.
#define COVERS(v) v.x
vec3 value(ivec2 texel) { return texelFetch(redrawn_triangles, texel, 0).ggg; }

vec4 shown(ivec2 texel) {
#if VIEW_AS == VIEW_AS_OVERLAY
  return vec4(1.0, 0.75, 0.1, 1.0);
#else
  return on_surfaces(texel, value(texel));
#endif
}

vec4 raw(ivec2 texel) { return vec4(value(texel), 1.0); }
