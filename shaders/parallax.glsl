// A height map below a flat surface: where the line of sight ends, and how far texture coordinates have moved by then.
// In the plane of the triangle, with its own texture coordinates, so that the field is as deep as it says in world units.

#if UVS_MOVED
uniform sampler2D uvs_moved;  // of each pixel
#else
uniform sampler2D height_map;  // red: 1 the flat surface, 0 the lowest place
uniform vec2 height;           // world units down to the lowest place, steps
uniform vec4 sight_from;       // where it is seen from, in the axes of `relative`; w = 0: along this direction

float depth_at(vec2 uv) { return 1.0 - textureLod(height_map, uv, 0.0).r; }

// Of the way down to the lowest place, the share that ends at the surface. way: how far uv moves on all of it.
float share_sunk(vec2 uv, vec2 way) {
  float below = depth_at(uv);
#if PARALLAX == PARALLAX_OFFSET
  return below;
#else
  float step = 1.0 / height.y, share = 0.0, before = below;
  for (int i = 0; i < int(height.y) && share < below; ++i) {
    before = below - share;
    share += step;
    below = depth_at(uv + share * way);
  }
#if PARALLAX == PARALLAX_OCCLUSION
  float after = share - below;
  return share - step * (after > 0.0 ? after / (before + after) : 0.0);
#elif PARALLAX == PARALLAX_RELIEF
  float high = max(share - step, 0.0);
  for (int i = 0; i < 8; ++i) {
    float middle = 0.5 * (high + share);
    if (middle < depth_at(uv + middle * way))
      high = middle;
    else
      share = middle;
  }
  return 0.5 * (high + share);
#else
  return share;
#endif
#endif
}
#endif

// Both are exact on a triangle, whose position and uv change alike from pixel to pixel.
void sink(vec3 flat_position, vec2 uv, out vec3 position, out vec2 uv_moved) {
  position = flat_position;
#if UVS_MOVED
  uv_moved = texelFetch(uvs_moved, ivec2(gl_FragCoord.xy), 0).xy;
#else
  uv_moved = vec2(0.0);
  vec3 right = dFdx(flat_position), up = dFdy(flat_position), area = cross(right, up);
  vec2 uv_right = dFdx(uv), uv_up = dFdy(uv);
  vec3 sight = sight_from.w != 0.0 ? normalize(flat_position - sight_from.xyz) : sight_from.xyz;
  float twice = dot(area, area);
  float cosine = abs(dot(area, sight)) * inversesqrt(twice);
  if (!gl_FrontFacing || !(twice > 0.0) || !(cosine > 1e-6)) return;
  vec2 way = height.x / cosine * (uv_right * dot(cross(up, area), sight) + uv_up * dot(cross(area, right), sight)) / twice;
  float share = share_sunk(uv, way);
  uv_moved = share * way;
  position += share * height.x / cosine * sight;
#endif
}
