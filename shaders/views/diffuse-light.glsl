// Displayed as the final picture is.
vec3 value(ivec2 texel) {
#if SPLIT
  return texelFetch(light_diffuse, texel, 0).rgb * light_scale.y;
#else
  return vec3(0.0);
#endif
}

vec4 shown(ivec2 texel) { return on_surfaces(texel, display(value(texel), shading.w)); }

vec4 raw(ivec2 texel) {
#if SPLIT
  return vec4(value(texel), 1.0);
#else
  return raw_lit(texel);
#endif
}
