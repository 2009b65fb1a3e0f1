// The gravest fault of a pixel: 1 above white, 2 its normal is not of length 1, 3 below 0, 4 no number.
bool no_number(vec3 v) { return !(abs(v.x) < 3.0e38 && abs(v.y) < 3.0e38 && abs(v.z) < 3.0e38); }

vec3 value(ivec2 texel) {
  vec3 light = texelFetch(lit, texel, 0).rgb, normal = vec3(1.0, 0.0, 0.0);
#if defined(STORED_NORMAL) || defined(NORMAL_IN_MATERIAL) && NORMAL_IN_MATERIAL
  if (read_depth(texel) != kFarDepth) normal = read_surface(texel).normal;
#endif
  if (no_number(light) || no_number(normal)) return vec3(4.0);
  if (min(light.x, min(light.y, light.z)) < 0.0) return vec3(3.0);
  if (abs(length(normal) - 1.0) > 0.005) return vec3(2.0);
  return vec3(max(light.x, max(light.y, light.z)) * shading.w > 1.0 ? 1.0 : 0.0);
}

vec4 shown(ivec2 texel) { return vec4(colour_of_class(int(value(texel).x)), 1.0); }

vec4 raw(ivec2 texel) { return vec4(value(texel) / 255.0, 1.0); }
