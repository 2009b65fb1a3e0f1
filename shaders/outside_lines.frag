uniform vec4 line_colour;
layout(location = 0) out vec4 picture;
void main() { picture = line_colour; }
