// Some texels of a picture of floats, as they are.
uniform sampler2D numbers;
uniform ivec4 pixel_grid;  // the first texel, the step
layout(location = 0) out vec4 picture;

void main() { picture = texelFetch(numbers, pixel_grid.xy + ivec2(gl_FragCoord.xy) * pixel_grid.zw, 0); }
