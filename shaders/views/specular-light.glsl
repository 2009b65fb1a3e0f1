// Displayed as the final picture is.
vec4 shown(ivec2 texel) {
#if SPLIT
  return on_surfaces(texel, display(texelFetch(light_specular, texel, 0).rgb * light_scale.y, shading.w));
#else
  return on_surfaces(texel, vec3(0.0));
#endif
}

vec4 raw(ivec2 texel) {
#if SPLIT
  return vec4(texelFetch(light_specular, texel, 0).rgb * light_scale.y, 1.0);
#else
  return raw_lit(texel);
#endif
}
