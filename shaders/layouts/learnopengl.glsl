// rgb: albedo, a: specular strength.
Stored pack_material(Surface s) {
  Stored t;
  t.material = vec4(albedo8(s.albedo), kept8(max(max(s.f0.r, s.f0.g), s.f0.b)));
  return t;
}

void unpack_material(Stored t, inout Surface s) {
  s.albedo = albedo_of8(t.material.rgb);
  s.f0 = vec3(t.material.a);
#if SHADING_MODEL == MODEL_GGX
  s.ambient = ambient_of(s);
#else
  s.ambient = s.albedo;  // a strength says nothing of metal
#endif
}
