// A G-buffer's pixels as points in space, in the colours of a view, seen from outside.
uniform sampler2D positions;  // from the camera
uniform sampler2D point_colours;
uniform mat4 outside_clip;    // from what is relative to the camera
uniform int stride;           // every stride-th pixel of a row and of a column
uniform float point_size;
flat out vec3 colour;

void main() {
  ivec2 size = textureSize(positions, 0);
  int columns = (size.x + stride - 1) / stride;
  ivec2 texel = ivec2(gl_VertexID % columns, gl_VertexID / columns) * stride;
  vec4 position = texelFetch(positions, texel, 0);
  colour = texelFetch(point_colours, texel, 0).rgb;
  gl_Position = position.a > 0.5 ? outside_clip * vec4(position.xyz, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
  gl_PointSize = point_size;
}
