// How far what is drawn is from the truth, with its sign: of the channel that is off most. gb: the surface that the frame
// shows. a = 1 where a surface is.
#include "gbuffer_read.glsl"
#include "frame_surface.glsl"

uniform sampler2D truth_lit;    // a = 1 where a surface is
uniform sampler2D truth_value;  // what ERROR_OF names
uniform sampler2D lit;
#if SPLIT
uniform sampler2D light_diffuse;
uniform sampler2D light_specular;
#endif
layout(location = 0) out vec4 error;

// The channel that is off most; what is not a number stays one, so that it shows.
float largest(vec3 d) {
  float sum = d.r + d.g + d.b;
  if (sum != sum) return sum;
  float m = abs(d.g) > abs(d.r) ? d.g : d.r;
  return abs(d.b) > abs(m) ? d.b : m;
}

// Degrees; atan of sine and cosine resolves angles that the cosine alone cannot.
float angle_deg(vec3 a, vec3 b) { return degrees(atan(length(cross(a, b)), dot(a, b))); }

float error_at(ivec2 texel) {
  vec4 truth = texelFetch(truth_value, texel, 0);
#if ERROR_OF == ERROR_FINAL
  return 255.0 * largest(display(texelFetch(lit, texel, 0).rgb, shading.w) - display(truth.rgb, shading.w));
#elif ERROR_OF == ERROR_LIT
  return largest(texelFetch(lit, texel, 0).rgb - truth.rgb);
#elif ERROR_OF == ERROR_DIFFUSE_LIGHT && SPLIT
  return largest(texelFetch(light_diffuse, texel, 0).rgb * light_scale.y - truth.rgb);
#elif ERROR_OF == ERROR_SPECULAR_LIGHT && SPLIT
  return largest(texelFetch(light_specular, texel, 0).rgb * light_scale.y - truth.rgb);
#elif ERROR_OF == ERROR_DEPTH
  return range_from_depth(read_depth(texel)) - dot(truth.xyz, ray_forward.xyz);
#elif ERROR_OF == ERROR_POSITION
  return distance(read_position(texel), truth.xyz);
#elif defined(STORED_MATERIAL)
  Surface s = read_surface(texel);
#if ERROR_OF == ERROR_NORMAL
  return angle_deg(s.normal, truth.xyz);
#elif ERROR_OF == ERROR_ALBEDO
  return largest(s.albedo - truth.rgb);
#elif ERROR_OF == ERROR_ROUGHNESS
  return s.roughness - truth.a;
#endif
#endif
  return 0.0;  // not stored: the view says so and is not drawn
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float present = texelFetch(truth_lit, texel, 0).a;
  error = vec4(present > 0.5 ? error_at(texel) : 0.0, frame_surface(texel), present);
}
