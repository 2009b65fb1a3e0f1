// By the same function as the lighting; where the surface is turned away or the light does not reach, nothing is to be hidden.
vec3 value(ivec2 texel) {
  if (picked_light < 0) return vec3(0.0);
  Surface s = read_surface(texel);
  Light light = read_light(picked_light);
  vec3 to_light = light.position - s.position;
#if LIGHT_KINDS
  if (light.kind == LIGHT_DIRECTIONAL) to_light = -light.direction;
#endif
  to_light = normalize(to_light);
  if (!reaches(light, s.position) || dot(s.normal, to_light) <= 0.0) return vec3(0.0);
#if SHADOWS
  return vec3(visibility(caster_of(light), s.position, s.normal, to_light));
#else
  return vec3(1.0);  // no light has a map: it passes through everything
#endif
}

vec4 shown(ivec2 texel) { return on_surfaces(texel, value(texel)); }

vec4 raw(ivec2 texel) { return vec4(value(texel), 1.0); }
