#pragma once
// A glTF file as plain data, in the file's own numbering: every index is in range or -1. Byte ranges are not checked
// here (gltf_accessor does that), nor is the shape of the node tree (gltf_nodes).
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "renderer/gltf/gltf_files.h"
#include "renderer/gltf/gltf_json.h"
#include "renderer/scene/scene.h"

namespace gbl::gltf {

struct BufferView {
  int buffer = 0;
  uint64_t offset = 0, length = 0, stride = 0;  // stride 0: packed
};

struct Sparse {
  uint64_t count = 0;
  int indices_view = -1, values_view = -1;
  uint64_t indices_offset = 0, values_offset = 0;
  int indices_type = 0;
};

struct Accessor {
  int view = -1;
  uint64_t offset = 0, count = 0;
  int component_type = 0;  // 5120 … 5126, as in the file
  int components = 1;      // 1, 2, 3, 4 or 16
  bool normalised = false;
  Sparse sparse;
};

struct Primitive {  // accessors, or -1
  int position = -1, normal = -1, tangent = -1, uv[2] = {-1, -1}, colour = -1, joints = -1, weights = -1;
  int indices = -1;
  int material = -1;
  int mode = 4;
};

struct MeshSource {
  std::string name;
  std::vector<Primitive> primitives;
};

struct Node {
  std::string name;
  int mesh = -1, skin = -1, camera = -1, light = -1;
  std::vector<int> children;
  glm::dmat4 parent_from_node{1};
};

struct Skin {
  std::vector<int> joints;
  int inverse_bind = -1;
};

struct TextureSource {
  int image = -1;
  Sampler sampler;
};

struct CameraSource {
  bool usable = false;
  bool endless = false;  // no far plane
  Camera camera;         // lens only
};

struct LightSource {
  bool usable = false;
  Light light;  // at the origin, looking along its own -Z
};

struct Document {
  std::vector<BufferView> views;
  std::vector<Accessor> accessors;
  std::vector<MeshSource> meshes;
  std::vector<Node> nodes;
  std::vector<std::vector<int>> scenes;  // their roots
  int scene = -1;                        // the one to show
  std::vector<Skin> skins;
  std::vector<Material> materials;  // their textures are indices into `textures`
  std::vector<TextureSource> textures;
  std::vector<CameraSource> cameras;
  std::vector<LightSource> lights;
  std::vector<Source> images;
  std::vector<std::span<const uint8_t>> buffers;  // empty: not there
  std::vector<Bytes> owned;                       // what `buffers` point into, unless it is the container
};

// Everything but the buffers' bytes.
Document read_document(TidyJson, Job&);

// A sampler from the file's codes; -1 and unknown ones mean the default. (Specification 5.26; gltf_sampler.cpp)
Sampler sampler_of(int wrap_s, int wrap_t, int min_filter, int mag_filter);

// The bytes of each buffer: files and data URIs are read, the container's chunk is used in place.
void load_buffers(Document&, std::vector<Source>& sources, std::span<const uint8_t> chunk, bool has_chunk, Folder&,
                  Job&);

}  // namespace gbl::gltf
