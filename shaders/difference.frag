// How far two pictures are apart, in codes of the display, with the sign of the channel that is off most. They may differ in
// size: B is stretched.
uniform sampler2D picture_a;
uniform sampler2D picture_b;
layout(location = 0) out vec4 difference;

void main() {
  vec2 at = gl_FragCoord.xy / vec2(textureSize(picture_a, 0));
  vec3 d = 255.0 * (texelFetch(picture_a, ivec2(gl_FragCoord.xy), 0).rgb - texture(picture_b, at).rgb);
  float most = d.r;
  if (abs(d.g) > abs(most)) most = d.g;
  if (abs(d.b) > abs(most)) most = d.b;
  difference = vec4(most, 0.0, 0.0, 1.0);
}
