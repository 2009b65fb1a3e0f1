#pragma once
// A scene as plain data: no GL, no files. World is right-handed, Y up, metres; transforms are double.
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <vector>

#include "renderer/camera.h"

namespace gbl {

struct Vertex {
  glm::vec3 position;         // object space
  glm::vec3 normal;           // unit
  glm::vec4 tangent;          // xyz unit along +u; w = +1 or -1: bitangent = w * cross(normal, tangent)
  glm::vec2 uv;               // origin top left, as glTF
};

struct Mesh {
  std::string name;
  std::vector<Vertex> vertices;
  std::vector<uint32_t> indices;  // triangles, counter-clockwise seen from outside
};

struct Texture {
  std::string name;
  glm::ivec2 size{0};
  std::vector<uint8_t> rgba;  // rows top to bottom; 4 bytes a texel; colour textures are sRGB-coded
};

inline constexpr int kNoTexture = -1;

// The metallic-roughness material of glTF 2.0; factors multiply texels.
struct Material {
  std::string name;
  glm::vec3 base_colour{1};            // linear
  float roughness = 1;                 // perceptual, 0..1
  int base_colour_texture = kNoTexture;  // sRGB
  int normal_texture = kNoTexture;       // tangent space, n * 0.5 + 0.5, +Y up (green = bitangent)
  int roughness_texture = kNoTexture;    // green channel, linear
};

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

struct Light {
  glm::dvec3 position;  // world
  glm::dvec3 colour;    // linear; times intensity
  double range;         // world units; no light at or beyond it
};

// How a scene places N generated lights: on a grid of side ceil(sqrt(N)), turning about a vertical axis.
// (Source 0: nclgl tutorial 15, renderer.cpp lines 10-27 and 204-222.)
struct LightGrid {
  glm::dvec2 extent{4112, 4112};  // x and z from 0; range = extent.x / side
  double height = 100;            // y of every light
  glm::dvec2 pivot{2056, 2056};   // x, z of the axis they turn about
  double degrees_per_s = 10;      // about +Y
};

struct Scene {
  std::string name;
  std::vector<Mesh> meshes;
  std::vector<Texture> textures;
  std::vector<Material> materials;
  std::vector<Instance> instances;
  LightGrid light_grid;
  Bounds bounds;   // of all instances, world
  Camera camera;   // the scene's own view
};

Bounds bounds_of(const Scene&);

}  // namespace gbl
