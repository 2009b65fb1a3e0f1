// A function of a user's, called once a pixel: FUNCTION_CALL is a vec4 in terms of a and b.
#include FUNCTION_FILE

uniform sampler2D function_a;
uniform sampler2D function_b;
out vec4 result;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 a = texelFetch(function_a, texel, 0), b = texelFetch(function_b, texel, 0);
  result = FUNCTION_CALL;
}
