// Displayed as the final picture is.
vec3 value(ivec2 texel) { return read_surface(texel).emissive; }

vec4 shown(ivec2 texel) { return on_surfaces(texel, display(value(texel), shading.w)); }

vec4 raw(ivec2 texel) {
#ifdef STORED_EMISSION
  return raw_texel(texelFetch(gbuffer_emission, texel, 0));
#elif defined(STORED_MATERIAL)
  return raw_texel(texelFetch(gbuffer_material, texel, 0));
#else
  return raw_lit(texel);
#endif
}
