// Deferred lighting: what the light passes need, and nothing else.
Stored pack_material(Surface s) {
  Stored t;
#if MATERIAL_FLOATS
  t.material = vec4(s.f0, s.roughness);
#else
  t.material = quantised8(vec4(s.f0, s.roughness));
#endif
  return t;
}

void unpack_material(Stored t, inout Surface s) {
  s.f0 = t.material.rgb;
  set_roughness(s, t.material.a);
  s.ambient = ambient_of(s);
}
