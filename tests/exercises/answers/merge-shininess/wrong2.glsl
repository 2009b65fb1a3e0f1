// attachments: material RGBA8 { rgb: diffuse colour, sRGB-coded; a: 1 } ambient RGBA8 { rgb: ambient colour, sRGB-coded; a: 1 } reflectance RGBA8 { rgb: specular colour; a: exponent / 256 }
Stored pack_material(Surface s) {
  Stored t;
  t.material = vec4(albedo8(s.albedo), 1.0);
  t.ambient = vec4(coded8(s.ambient), 1.0);
  t.reflectance = vec4(quantised8(s.f0), kept8(stored_exponent(s) / 256.0));
  return t;
}

void unpack_material(Stored t, inout Surface s) {
  s.albedo = albedo_of8(t.material.rgb);
  s.f0 = t.reflectance.rgb;
  set_exponent(s, t.reflectance.a * 256.0);
  s.ambient = linear_from_coded(t.ambient.rgb);
}
