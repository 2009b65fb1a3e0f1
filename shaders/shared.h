// The formatter would take the block for a function.
// clang-format off
// Compiled by GLSL and by C++ alike: what both must agree on. Only vec4, ivec4 and mat4, so that std140 and C++
// lay the block out in the same way.
#ifdef __cplusplus
#define GBL_BLOCK(name) struct name
#else
#define GBL_BLOCK(name) layout(std140) uniform name
#endif

// Records of lights, RGBA32F texels. What each pair needs:
//   0: position relative to the camera, range   1: colour, the range that the falloff's profile is a function of
#define LIGHT_TEXELS 2
// After the last light come so many of no colour and no range, for what takes four lights at once.
#define DARK_LIGHTS 4
// … and the rest:
//   0: kind, the volume's shape, its first shadow map (-1: none)   1: direction, inner cosine   2: outer cosine, falloff coefficients
#define LIGHT_TRAIT_TEXELS 3
// After the dark lights, where a method asks: of each light its screen bounds (NDC: x from, y from, x to, y to). After their traits, where
// any light is special: the order in which fours are read, light_order() of lights.glsl. Neither table then holds more than 65536 texels,
// the least that MAX_TEXTURE_BUFFER_SIZE may be.
#define LIGHT_POINT 0
#define LIGHT_SPOT 1
#define LIGHT_DIRECTIONAL 2

// Records of shadow maps, RGBA32F texels: 0-3 columns of clip_from_relative   4: the tile's corner in texels,
// world units of a texel (of a perspective map at distance 1), where the next cascade takes over along the view axis
#define SHADOW_MAP_TEXELS 5

// What stands for a light where volumes are drawn; SCREEN: a light without end.
#define VOLUME_SPHERE 0
#define VOLUME_CONE 1
#define VOLUME_SCREEN 2

// The lights that an instanced draw keeps, by where the camera is.
#define KEEP_ALL 0
#define KEEP_INSIDE 1
#define KEEP_OUTSIDE 2

// Records of instances, RGBA32F texels: 0-3 columns of clip_from_object, 4-6 rows of
// relative_from_object (3x4), 7-9 columns of the normals' matrix; 7.w: -1 where mirrored, 8.w: the object's number, from 1.
#define INSTANCE_TEXELS 10

// The textures of a material, in this order wherever they are listed.
#define MATERIAL_TEXTURES 8
#define BASE_COLOUR_MAP 0
#define NORMAL_MAP_ 1
#define ROUGHNESS_MAP 2
#define EMISSIVE_MAP 3
#define OCCLUSION_MAP 4
#define SPECULAR_MAP 5
#define SPECULAR_COLOUR_MAP 6
#define HEIGHT_MAP 7

// What views.frag draws of a view.
#define VIEW_AS_SHOWN 0
#define VIEW_AS_STORED 1
#define VIEW_AS_NUMBERS 2
#define VIEW_AS_LOOK 3
#define VIEW_AS_OVERLAY 4

// What redrawn.frag draws of the objects.
#define REDRAWN_WRITTEN 0
#define REDRAWN_TRIANGLES 1
#define REDRAWN_CULLED 2

// Blocks of pixels summed by one texel of the count reduction: 16 x 16 x 16384 lights < 2^24 is exact in float.
#define COUNT_BLOCK 16

GBL_BLOCK(FrameBlock) {
  mat4 clip_from_relative;   // relative = world axes, origin at the camera
  mat4 world_from_clip;      // float inverse of the float view-projection: the pitfall's matrix
  mat4 clip_from_world;      // the float view-projection
  mat4 view_from_world;      // the rotation alone
  vec4 ray_forward;          // see ViewRays in camera.h; w = 1 if orthographic
  vec4 ray_right;
  vec4 ray_up;
  vec4 camera_position;      // world; w unused
  vec4 planes;               // near, far, near * far, far - near
  vec4 viewport;             // width, height, 1/width, 1/height
  vec4 background;           // linear colour
  vec4 shading;              // exponent (-1: from roughness), specular factor, ambient, exposure
  vec4 position_cycle;       // x: world units in which the position view's colours repeat
  vec4 light_scale;          // what light sums are stored times, 1 over it: powers of two (resolved_frame.h)
  vec4 shadow_bias;          // in texels: towards the light, times the slope, along the normal; w unused
  ivec4 lights;              // count, -, -, -
};

#undef GBL_BLOCK
