// Transparent surfaces, after lighting: every light by the loop, blended over what is behind.
#include "material.glsl"
#include "shade.glsl"

layout(location = 0) out vec4 radiance;

void main() {
  vec4 base = material_base();
  Surface s = material_surface(base);
  vec3 sum = shading.z * s.occlusion * (s.albedo + s.f0) + s.emissive;
#if !UNLIT
  for (int i = 0; i < lights.x; ++i) {
    Lighting one = shade(s, read_light(i));
    sum += s.albedo * one.diffuse + one.specular;
  }
#endif
  radiance = vec4(sum, base.a);
}
