// Which surface the frame shows: object from 1 (0: background), triangle of its mesh from 0. -1 where the frame's depth
// is not that of the surface which these settings draw in front: what it shows then is not known, and nothing excuses it.
uniform sampler2D surfaces;
uniform sampler2D surfaces_depth;

vec2 frame_surface(ivec2 texel) {
  bool drawn = texelFetch(surfaces_depth, texel, 0).r == read_depth(texel);
  return drawn ? texelFetch(surfaces, texel, 0).xy : vec2(-1.0);
}
