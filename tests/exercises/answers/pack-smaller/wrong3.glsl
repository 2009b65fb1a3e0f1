// attachments: material RGBA8 { rgb: albedo, sRGB-coded; a: roughness }
// Metal and emission are left out.
Stored pack_material(Surface s) {
  Stored t;
  t.material = vec4(albedo8(s.albedo), kept8(s.roughness));
  return t;
}

void unpack_material(Stored t, inout Surface s) {
  s.albedo = albedo_of8(t.material.rgb);
  set_roughness(s, t.material.a);
  s.ambient = ambient_of(s);
}
