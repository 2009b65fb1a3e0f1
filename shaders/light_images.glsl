// A compute shader's targets: images of the targets' own format. There is no blending here; it adds by itself.
#if IMAGE_FORMAT == FORMAT_RGBA8
#define STORED rgba8
#elif IMAGE_FORMAT == FORMAT_R11G11B10F
#define STORED r11f_g11f_b10f
#elif IMAGE_FORMAT == FORMAT_RGBA16F
#define STORED rgba16f
#else
#define STORED rgba32f
#endif

layout(STORED, binding = 0) uniform image2D image_first;  // diffuse light, or the sum
layout(STORED, binding = 1) uniform image2D image_second;

void add_sum(vec3 sum) {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  imageStore(image_first, texel, imageLoad(image_first, texel) + vec4(sum, 0.0));
}
void add_diffuse(vec3 light) { add_sum(light); }
void add_specular(vec3 light) {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  imageStore(image_second, texel, imageLoad(image_second, texel) + vec4(light, 0.0));
}
