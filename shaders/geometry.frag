// Material and normal of what is visible, packed as the layout says.
#include "material.glsl"

layout(location = 0) out vec4 out_material;
layout(location = 1) out NORMAL_OUTPUT out_normal;
#if MATERIAL_TARGETS > 1
layout(location = 2) out vec4 out_reflectance;
layout(location = 3) out vec4 out_emission;
#endif

void main() {
  vec4 base = material_base();
#if ALPHA_MASK
  if (base.a < alpha_cutoff) discard;
#endif
  Surface s = material_surface(base);
  out_material = pack_material(s);
  out_normal = pack_normal(s.normal);
#if MATERIAL_TARGETS > 1
  out_reflectance = pack_reflectance(s);
  out_emission = pack_emission(s);
#endif
}
