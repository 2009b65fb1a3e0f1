// The colours of the errors: a bar of evenly spaced stops from 0 to the range, or from minus to plus it.
uniform sampler2D errors;
uniform vec3 stops[COLOUR_STOPS];
uniform float range;
uniform vec3 empty_colour;
uniform vec3 tie_colour;
layout(location = 0) out vec4 picture;

void main() {
  vec4 e = texelFetch(errors, ivec2(gl_FragCoord.xy), 0);
  if (e.a < 0.5) {
    picture = vec4(empty_colour, 1.0);
  } else if (!(abs(e.r) < 3.0e38)) {
    picture = vec4(1.0, 0.0, 1.0, 1.0);  // not a number, or without bound: never shown as black
  } else if (e.a > 1.5) {
    picture = vec4(tie_colour, 1.0);
  } else {
#if SIGNED
    float t = 0.5 + 0.5 * e.r / range;
#else
    float t = abs(e.r) / range;
#endif
    float at = clamp(t, 0.0, 1.0) * float(COLOUR_STOPS - 1);
    int i = min(int(at), COLOUR_STOPS - 2);
    picture = vec4(mix(stops[i], stops[i + 1], at - float(i)), 1.0);
  }
}
