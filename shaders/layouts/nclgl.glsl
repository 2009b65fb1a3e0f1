// rgb: colour; alpha is written and never read.
Stored pack_material(Surface s) {
  Stored t;
  t.material = vec4(coded8(s.albedo), 1.0);
  return t;
}

void unpack_material(Stored t, inout Surface s) {
  s.albedo = linear_from_coded(t.material.rgb);
  s.ambient = ambient_of(s);
}
