// Ambient, diffuse and specular colour; the exponent as a share of 256.
Stored pack_material(Surface s) {
  Stored t;
  t.ambient = vec4(coded8(s.ambient), 1.0);
  t.material = vec4(albedo8(s.albedo), 1.0);
  t.reflectance = quantised8(vec4(s.f0, stored_exponent(s) / 256.0));
  return t;
}

void unpack_material(Stored t, inout Surface s) {
  s.albedo = albedo_of8(t.material.rgb);
  s.f0 = t.reflectance.rgb;
  set_exponent(s, t.reflectance.a * 256.0);
  s.ambient = linear_from_coded(t.ambient.rgb);
}
