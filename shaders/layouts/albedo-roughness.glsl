// rgb: albedo, a: roughness.
Stored pack_material(Surface s) {
  Stored t;
  t.material = vec4(coded8(s.albedo), kept8(s.roughness));
  return t;
}

void unpack_material(Stored t, inout Surface s) {
  s.albedo = linear_from_coded(t.material.rgb);
  set_roughness(s, t.material.a);
  s.ambient = ambient_of(s);
}
