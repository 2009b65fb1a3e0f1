// Material, normal and position of what is visible, packed as the layout says.
#include "material.glsl"
#include "packing.glsl"
#include "position.glsl"

layout(location = STORED_MATERIAL) out MATERIAL_TEXEL out_material;
#ifdef STORED_NORMAL
layout(location = STORED_NORMAL) out NORMAL_OUTPUT out_normal;
#endif
#ifdef STORED_REFLECTANCE
layout(location = STORED_REFLECTANCE) out MATERIAL_TEXEL out_reflectance;
#endif
#ifdef STORED_EMISSION
layout(location = STORED_EMISSION) out MATERIAL_TEXEL out_emission;
#endif
#ifdef STORED_AMBIENT
layout(location = STORED_AMBIENT) out vec4 out_ambient;
#endif
#ifdef STORED_SHININESS
layout(location = STORED_SHININESS) out vec4 out_shininess;
#endif
#ifdef STORED_ID
layout(location = STORED_ID) out uvec4 out_id;
#endif
#ifdef STORED_POSITION
layout(location = STORED_POSITION) out vec4 out_position;
#endif
#ifdef STORED_LIGHT
layout(location = STORED_LIGHT) out vec4 out_light;
#endif

void main() {
  place_surface();
  vec4 base = material_base();
#if ALPHA_MASK
  if (base.a < alpha_cutoff) discard;
#endif
  Surface s = material_surface(base);
  Stored t = pack_material(s);
  out_material = t.material;
#ifdef STORED_NORMAL
  out_normal = pack_normal(s.normal);
#endif
#ifdef STORED_REFLECTANCE
  out_reflectance = t.reflectance;
#endif
#ifdef STORED_EMISSION
  out_emission = t.emission;
#endif
#ifdef STORED_AMBIENT
  out_ambient = t.ambient;
#endif
#ifdef STORED_SHININESS
  out_shininess = t.shininess;
#endif
#ifdef STORED_ID
  out_id = uvec4(object_id, 0u, 0u, 0u);
#endif
#ifdef STORED_POSITION
  out_position = pack_position(s.position);
#endif
#ifdef STORED_LIGHT
  out_light = vec4((shading.z * s.ambient + s.emissive) * light_scale.x, 0.0);
#endif
}
