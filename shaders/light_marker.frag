// The light's own colour, unlit.
flat in vec3 colour;
layout(location = 0) out vec4 radiance;

void main() { radiance = vec4(colour, 1.0); }
