// Diffuse colour; specular colour and roughness. Ambient light and emission begin the sum, or stand beside it where the
// light's sums are kept apart.
Stored pack_material(Surface s) {
  Stored t;
  t.material = vec4(albedo8(s.albedo), 1.0);
  t.reflectance = quantised8(vec4(s.f0, s.roughness));
#ifdef STORED_EMISSION
  t.emission = vec4((shading.z * s.ambient + s.emissive) * light_scale.x, 0.0);
#endif
  return t;
}

void unpack_material(Stored t, inout Surface s) {
  s.albedo = albedo_of8(t.material.rgb);
  s.f0 = t.reflectance.rgb;
  set_roughness(s, t.reflectance.a);
  s.ambient = vec3(0.0);
#ifdef STORED_EMISSION
  s.emissive = t.emission.rgb * light_scale.y;
#endif
}
