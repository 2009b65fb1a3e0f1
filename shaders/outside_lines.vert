// Lines and faces between a few points: the camera, its frustum, its near plane.
uniform vec3 corners[24];  // from the camera
uniform mat4 outside_clip;

void main() { gl_Position = outside_clip * vec4(corners[gl_VertexID], 1.0); }
