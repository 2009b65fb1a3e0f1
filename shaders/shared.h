// Compiled by GLSL and by C++ alike: what both must agree on. Only vec4, ivec4 and mat4, so that std140 and C++
// lay the block out in the same way.
#ifdef __cplusplus
#define GBL_BLOCK(name) struct name
#else
#define GBL_BLOCK(name) layout(std140) uniform name
#endif

// Light records in the light texture: kTexelsPerLight RGBA32F texels each.
//   texel 0: position relative to the camera, range        texel 1: colour, 0
#define LIGHT_TEXELS 2
#define LIGHT_TEXTURE_WIDTH 256

// Blocks of pixels summed by one texel of the count reduction: 16 x 16 x 16384 lights < 2^24 is exact in float.
#define COUNT_BLOCK 16

// Texels of a probe; their meaning stands in probe.frag.
#define PROBE_FIELDS 8

GBL_BLOCK(FrameBlock) {
  mat4 clip_from_relative;   // relative = world axes, origin at the camera
  mat4 world_from_clip;      // float inverse of the float view-projection: the pitfall's matrix
  vec4 ray_forward;          // see ViewRays in camera.h; w = 1 if orthographic
  vec4 ray_right;
  vec4 ray_up;
  vec4 camera_position;      // world; w unused
  vec4 planes;               // near, far, near * far, far - near
  vec4 viewport;             // width, height, 1/width, 1/height
  vec4 background;           // linear colour
  vec4 shading;              // exponent (-1: from roughness), specular factor, ambient, exposure
  vec4 view_range;           // depth view: from, to in world units
  ivec4 lights;              // count, -, -, -
};

#undef GBL_BLOCK
