// What an object mirrors, added to what it sends back of the lights: a picture from behind its plane, or six from its middle.
#include "material.glsl"
#include "shade.glsl"
#include "cube.glsl"

uniform sampler2D mirrored;
#if !MIRROR_FLAT
uniform mat3 side_from_world[6];  // view of each
uniform vec4 side_place;          // x, y: of the first side's corner, in texels; z: texels to a side; w: 1 / tangent of half the angle
#endif
#if MIRROR_BOX
uniform vec3 box_low;  // of the scene, relative to the camera; and the cube's middle
uniform vec3 box_high;
uniform vec3 side_centre;
#endif
layout(location = 0) out vec4 radiance;

#if !MIRROR_FLAT
// As seen from the surface: where the ray leaves the scene's box, as the cube's middle sees it.
vec3 bent(vec3 direction) {
#if MIRROR_BOX
  vec3 slant = mix(direction, vec3(1e-20), equal(direction, vec3(0.0)));  // along a wall: it never meets it
  vec3 away = (mix(box_low, box_high, greaterThan(slant, vec3(0.0))) - relative) / slant;
  float reach = max(min(away.x, min(away.y, away.z)), 0.0);
  return relative + reach * direction - side_centre;
#else
  return direction;
#endif
}

vec3 seen_along(vec3 direction) {
  direction = bent(direction);
  int side = cube_face(direction);
  vec3 v = side_from_world[side] * direction;
  vec2 within = (v.xy / -v.z * side_place.w * 0.5 + 0.5) * side_place.z;
  vec2 at = side_place.xy + vec2(float(side) * side_place.z, 0.0) + clamp(within, vec2(0.5), vec2(side_place.z - 0.5));
  return textureLod(mirrored, at / vec2(textureSize(mirrored, 0)), 0.0).rgb;
}
#endif

void main() {
  place_surface();
  Surface s = material_surface(material_base());
  vec3 to_eye = to_eye_of(s.position);
#if MIRROR_FLAT
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 seen = texelFetch(mirrored, ivec2(textureSize(mirrored, 0).x - 1 - pixel.x, pixel.y), 0).rgb;
#else
  vec3 seen = seen_along(reflect(-to_eye, s.normal));
#endif
  vec3 share = s.f0 + F_Schlick(max(dot(s.normal, to_eye), 0.0)) * grazing_of(s.f0);
  vec3 sum = share * seen;
#if REFRACTS && !MIRROR_FLAT
  // Bent once: where the light enters. Where it leaves is not known here.
  sum += (1.0 - share) * through_share() * tint().rgb * seen_along(refract(-to_eye, s.normal, transmission.y));
#endif
  // What stood for it: ambient light on the gloss.
  radiance = vec4(sum - shading.z * (s.ambient - s.occlusion * s.albedo), 0.0);
}
