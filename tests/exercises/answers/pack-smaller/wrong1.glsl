// attachments: material RGBA32F { rgb: albedo; a: roughness } reflectance RGBA32F { rgb: F0; a: occlusion } emission RGBA32F { rgb: emission; a: metal }
Stored pack_material(Surface s) {
  Stored t;
  t.material = vec4(s.albedo, s.roughness);
  t.reflectance = vec4(s.f0, s.occlusion);
  t.emission = vec4(s.emissive, s.metal);
  return t;
}

void unpack_material(Stored t, inout Surface s) {
  s.albedo = t.material.rgb;
  set_roughness(s, t.material.a);
  s.f0 = t.reflectance.rgb;
  s.occlusion = t.reflectance.a;
  s.emissive = t.emission.rgb;
  s.metal = t.emission.a;
  s.ambient = ambient_of(s);
}
