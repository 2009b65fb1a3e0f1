// The reference as a picture, displayed as the lab's own frames are.
#include "shared.h"
#include "colour.glsl"

uniform sampler2D truth_lit;
layout(location = 0) out vec4 picture;

void main() { picture = vec4(display(texelFetch(truth_lit, ivec2(gl_FragCoord.xy), 0).rgb, shading.w), 1.0); }
