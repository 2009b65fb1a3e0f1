flat in vec3 colour;
layout(location = 0) out vec4 picture;
void main() { picture = vec4(colour, 1.0); }
