// Roughness, or the colour of the highlight where the layout stores that.
vec3 value(ivec2 texel) {
  Surface s = read_surface(texel);
#if MATERIAL_VIEW == MATERIAL_VIEW_ROUGHNESS
  return vec3(s.roughness);
#else
  return s.f0;
#endif
}

vec4 shown(ivec2 texel) { return on_surfaces(texel, clamp(value(texel), 0.0, 1.0)); }

vec4 raw(ivec2 texel) {
#ifndef STORED_MATERIAL
  return raw_lit(texel);
#elif MATERIAL_WORDS
  return raw_texel(texelFetch(gbuffer_material, texel, 0));
#elif defined(STORED_REFLECTANCE)
  return texelFetch(gbuffer_reflectance, texel, 0);
#else
  return vec4(texelFetch(gbuffer_material, texel, 0).aaa, 1.0);
#endif
}
