#pragma once
// A scene as plain data: no GL, no files. World is right-handed, Y up, metres; transforms are double.
#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "renderer/scene/camera.h"

namespace gbl {

struct Vertex {
  glm::vec3 position;   // object space
  glm::vec3 normal;     // unit
  glm::vec4 tangent;    // xyz unit along +u; w = +1 or -1: bitangent = w * cross(normal, tangent)
  glm::vec2 uv;         // origin top left, as glTF
  glm::vec2 uv1{0};     // a second set
  glm::vec4 colour{1};  // linear; multiplies the base colour
};

struct Mesh {
  std::string name;
  std::vector<Vertex> vertices;
  std::vector<uint32_t> indices;  // triangles, counter-clockwise seen from outside
};

enum class Wrap { repeat, clamp, mirror };
enum class Filter {
  nearest,
  linear,
  nearest_mipmap_nearest,
  linear_mipmap_nearest,
  nearest_mipmap_linear,
  linear_mipmap_linear
};
struct Sampler {
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  Filter min = Filter::linear_mipmap_linear, mag = Filter::linear;
  bool operator==(const Sampler&) const = default;
};

struct Texture {
  std::string name;
  glm::ivec2 size{0};
  std::vector<uint8_t> rgba;     // rows top to bottom; 4 bytes a texel; colour textures are sRGB-coded
  std::vector<uint16_t> rgba16;  // the same of an image with 16 bits a channel; then `rgba` is empty
  Sampler sampler;

  bool empty() const { return rgba.empty() && rgba16.empty(); }
  glm::dvec4 texel(size_t i) const {  // 0..1, as coded
    return rgba16.empty()
               ? glm::dvec4(rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2], rgba[4 * i + 3]) / 255.0
               : glm::dvec4(rgba16[4 * i], rgba16[4 * i + 1], rgba16[4 * i + 2], rgba16[4 * i + 3]) / 65535.0;
  }
};

inline constexpr int kNoTexture = -1;

// A texture as a material reads it.
struct TextureUse {
  int texture = kNoTexture;
  int uv_set = 0;             // 0 or 1
  glm::mat3 uv_transform{1};  // of KHR_texture_transform: texel uv = (transform * (u, v, 1)).xy
};

enum class AlphaMode { opaque, mask, blend };

// The metallic-roughness material of glTF 2.0; factors multiply texels.
struct Material {
  std::string name;
  glm::vec4 base_colour{1};  // linear; a: coverage, used as alpha_mode says
  float roughness = 1;       // perceptual, 0..1
  float metal = 0;           // 0..1
  glm::vec3 emissive{0};     // linear, times any emissive strength
  float normal_scale = 1;    // of the map's x and y
  float occlusion_strength = 1;
  // What is no metal reflects at normal incidence: min(that of the index x colour, 1) x weight (KHR_materials_ior,
  // KHR_materials_specular).
  float refraction_index = 1.5f;       // 1 or more; 0: reflects all
  float specular = 1;                  // the weight, 0..1
  glm::vec3 specular_colour{1};        // linear, 0 or more
  TextureUse base_colour_texture;      // sRGB
  TextureUse normal_texture;           // tangent space, n * 0.5 + 0.5, +Y up (green = bitangent)
  TextureUse roughness_texture;        // green: roughness, blue: metal; linear
  TextureUse emissive_texture;         // sRGB
  TextureUse occlusion_texture;        // red; linear
  TextureUse specular_texture;         // alpha; linear
  TextureUse specular_colour_texture;  // sRGB
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;  // of mask
  bool double_sided = false;
  bool unlit = false;      // shown as it is, lit by nothing
  float transmission = 0;  // share of the light that does not bounce off but goes through (KHR_materials_transmission)
  // How deep the surface lies below its triangles, seen from the front: depth x (1 - red). glTF has none. Texture
  // coordinates of the first set, not moved.
  TextureUse height_texture;  // linear
  float height_depth = 0;     // world units, whatever the object's scale
};

inline bool has_heights(const Material& m) {
  return m.height_texture.texture != kNoTexture && m.height_depth > 0 && m.alpha_mode != AlphaMode::blend;
}

// Each texture that a material reads, in the order of shaders/shared.h.
template <class M>  // Material, const or not
auto texture_uses(M& m) {
  return std::array{&m.base_colour_texture, &m.normal_texture,   &m.roughness_texture,       &m.emissive_texture,
                    &m.occlusion_texture,   &m.specular_texture, &m.specular_colour_texture, &m.height_texture};
}

// Schlick 1994: the reflectance of a surface between air and a medium of this index, at normal incidence.
inline double reflectance_of_index(double index) {
  const double r = (index - 1) / (index + 1);
  return r * r;
}
inline constexpr double kCommonReflectance = 0.04;  // of index 1.5, which is glTF's default

// Does its non-metal part reflect as that of every other material does?
inline bool reflects_as_common(const Material& m) {
  return m.refraction_index == 1.5f && m.specular == 1 && m.specular_colour == glm::vec3(1) &&
         m.specular_texture.texture == kNoTexture && m.specular_colour_texture.texture == kNoTexture;
}

struct Instance {
  std::string name;
  int mesh = 0, material = 0;
  glm::dmat4 world_from_object{1};
};

struct Bounds {
  glm::dvec3 min{0}, max{0};
  glm::dvec3 centre() const { return (min + max) * 0.5; }
  glm::dvec3 extent() const { return max - min; }
};

enum class LightKind { point, spot, directional };

inline constexpr double kEndless = 1e30;  // range of a light without end

struct Light {
  glm::dvec3 position{0};   // world; of a directional light unused
  glm::dvec3 colour{1};     // linear; times intensity
  double range = kEndless;  // world units; no light at or beyond it
  bool ends_faint = false;  // its source states no range: it ends where the display cannot show it (lights_of())
  LightKind kind = LightKind::point;
  glm::dvec3 direction{0, -1, 0};       // unit, from the light; of spot and directional
  double inner_cos = 1, outer_cos = 0;  // of a spot: full within the inner cone, none outside the outer
  glm::dvec3 coefficients{0};           // its own falloff 1/(x + y d + z d^2), before the settings'; all 0: none
  double profile_range = 0;             // what the settings' falloff is a function of; set by lights_of()
  bool operator==(const Light&) const = default;
};

// How a scene places N generated lights: on a grid of side ceil(sqrt(N)), turning about a vertical axis.
// (Source 0: nclgl tutorial 15, renderer.cpp lines 10-27 and 204-222.)
struct LightGrid {
  glm::dvec2 extent{4112, 4112};  // x and z from 0; range = extent.x / side
  double height = 100;            // y of every light
  glm::dvec2 pivot{2056, 2056};   // x, z of the axis they turn about
  double degrees_per_s = 10;      // about +Y
};

// How a scene places N generated lights in a box: uniformly, by seed.
enum class BoxRange {
  overlap,   // so that a point of the box lies in `overlap` lights on average, whatever N is
  fixed,     // `range` each
  quadratic  // where colour / (1 + 0.7 d + 1.8 d^2) falls to 5/256 (source 2)
};
struct LightBox {
  glm::dvec3 min{0}, max{0};
  BoxRange rule = BoxRange::overlap;
  double overlap = 4;
  double range = 1;
  double colour_min = 0.5, colour_max = 1.5;  // each channel
};

struct Scene {
  std::string name;
  std::vector<Mesh> meshes;
  std::vector<Texture> textures;
  std::vector<Material> materials;
  std::vector<Instance> instances;
  std::vector<Light> lights;          // the scene's own
  std::optional<LightBox> light_box;  // for generated lights; without one, the grid
  LightGrid light_grid;
  Bounds bounds;                      // of all instances, world
  Camera camera;                      // the scene's own view
  bool studio_lights = false;         // `lights` were added to a file that has none
  double exposure = 1;                // that shows its own lights well
  std::vector<std::string> warnings;  // what was skipped or replaced, a line each
};

// Every vertex of every instance, in the world; where these are many millions, the corners of the meshes' boxes.
void visit_points(const Scene&, const std::function<void(const glm::dvec3&)>&);

Bounds bounds_of(const Scene&);  // of no point: empty, at the origin
Bounds bounds_of(const Mesh&);   // in object space; of no point: kNoBounds

// A box that grows: kNoBounds includes no point.
inline constexpr Bounds kNoBounds{glm::dvec3(std::numeric_limits<double>::infinity()),
                                  glm::dvec3(-std::numeric_limits<double>::infinity())};
inline void include(Bounds& b, const glm::dvec3& p) { b.min = glm::min(b.min, p), b.max = glm::max(b.max, p); }
std::array<glm::dvec3, 8> corners_of(const Bounds&);

}  // namespace gbl
