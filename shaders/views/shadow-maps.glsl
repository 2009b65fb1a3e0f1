// The texture of all maps, as large as fits; the first map at the top left, each map the right way up.
vec3 value(ivec2 texel) {
#if SHADOWS
  vec2 size = vec2(textureSize(shadow_depth, 0));
  float scale = max(size.x / viewport.x, size.y / viewport.y);
  ivec2 at = ivec2(floor(vec2(float(texel.x) + 0.5, viewport.y - float(texel.y) - 0.5) * scale));
  if (at.x >= int(size.x) || at.y >= int(size.y)) return vec3(-1.0);
  ivec2 tile = at / SHADOW_TEXELS, within = at - tile * SHADOW_TEXELS;
  int map = tile.y * (int(size.x) / SHADOW_TEXELS) + tile.x;
  within.y = SHADOW_TEXELS - 1 - within.y;
  float depth = texelFetch(shadow_depth, tile * SHADOW_TEXELS + within, 0).r;
  if (shadow_record(map * SHADOW_MAP_TEXELS + 4).w > 0.0) return vec3(depth);  // a sun's
  mat4 clip = shadow_matrix(map);
  float steep = length(vec3(clip[0].z, clip[1].z, clip[2].z));  // (far + near) / (far - near)
  float near_share = (steep - 1.0) / (steep + 1.0);
  return vec3(near_share > 0.0 ? near_share / (1.0 - depth * (1.0 - near_share)) : 1.0);
#else
  return vec3(-1.0);
#endif
}

vec4 shown(ivec2 texel) {
  float share = value(texel).r;
  return vec4(share < 0.0 ? empty_colour : vec3(clamp(share, 0.0, 1.0)), 1.0);
}

vec4 raw(ivec2 texel) { return vec4(value(texel), 1.0); }
