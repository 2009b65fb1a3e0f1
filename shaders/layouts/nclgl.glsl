// rgb: colour; alpha is written and never read.
Stored pack_material(Surface s) {
  Stored t;
  t.material = vec4(albedo8(s.albedo), 1.0);
  return t;
}

void unpack_material(Stored t, inout Surface s) {
  s.albedo = albedo_of8(t.material.rgb);
  s.ambient = ambient_of(s);
}
