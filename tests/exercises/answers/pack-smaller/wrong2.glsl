// attachments: material RGBA8 { rgb: base colour, sRGB-coded; a: roughness } reflectance RG8 { r: metal; g: occlusion } emission RGBA8 { rgb: emission, sRGB-coded as displayed; a: 1 }
Stored pack_material(Surface s) {
  Stored t;
  t.material = vec4(albedo8(base_of(s)), kept8(s.roughness));
  t.reflectance = vec4(kept8(s.metal), kept8(s.occlusion), 0.0, 0.0);
  t.emission = vec4(quantised8(shown_emission(s)), 1.0);
  return t;
}

void unpack_material(Stored t, inout Surface s) {
  s.metal = t.reflectance.r;
  s.occlusion = t.reflectance.g;
  set_base(s, albedo_of8(t.material.rgb));
  set_roughness(s, t.material.a);
  s.ambient = ambient_of(s);
}
