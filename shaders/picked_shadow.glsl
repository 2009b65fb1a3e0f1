// The map of the picked light that a surface reads; -1: none, or the light does not reach it.
int map_of_picked(Surface s) {
#if SHADOWS
  if (picked_light < 0) return -1;
  Light light = read_light(picked_light);
  if (light.shadow_map < 0 || !reaches(light, s.position)) return -1;
  return shadow_map_of(caster_of(light), s.position);
#else
  return -1;
#endif
}
