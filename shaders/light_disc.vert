// A fan of DISC_SIDES triangles per light: a disc through its centre, parallel to the image plane, as source 4 draws it
// (geopointlight). It is smaller than the sphere's outline, and the division by hand mirrors what is behind the camera:
// with w in gl_Position the hardware would clip there.
#include "lights.glsl"
#include "varyings.glsl"

flat out int light;

vec4 corner_of_screen() {  // as fullscreen.vert; the other triangles have no area
  if (gl_VertexID > 2) return vec4(2.0, 2.0, 0.0, 1.0);
  return vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}

void main() {
  pass_varyings();
  light = gl_InstanceID;
  Light l = read_light(light);
  int corner = gl_VertexID % 3;  // 0: the centre
  vec3 position = l.position;
  if (corner > 0) {
    float turn = radians(360.0 / float(DISC_SIDES) * float((gl_VertexID / 3 + corner - 1) % DISC_SIDES));
    position += l.range * (sin(turn) * normalize(ray_up.xyz) - cos(turn) * normalize(ray_right.xyz));
  }
  vec4 clip = clip_from_relative * vec4(position, 1.0);
  gl_Position = endless(l.range, light) ? corner_of_screen() : vec4(clip.xy / clip.w, 0.0, 1.0);
}
