// attachments: material RGBA8 { rgb: diffuse colour, sRGB-coded; a: 1 } ambient RGBA8 { rgb: ambient colour, sRGB-coded; a: 1 } reflectance RGBA8 { rgb: specular colour; a: roughness }
Stored pack_material(Surface s) {
  Stored t;
  t.material = vec4(albedo8(s.albedo), 1.0);
  t.ambient = vec4(coded8(s.ambient), 1.0);
  t.reflectance = vec4(quantised8(s.f0), kept8(roughness_from_exponent(stored_exponent(s))));
  return t;
}

void unpack_material(Stored t, inout Surface s) {
  s.albedo = albedo_of8(t.material.rgb);
  s.f0 = t.reflectance.rgb;
  set_roughness(s, t.reflectance.a);
  s.ambient = linear_from_coded(t.ambient.rgb);
}
