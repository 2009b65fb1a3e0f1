#pragma once
// Small glTF files made by code, for tests and as seeds for fuzzing.
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "renderer/gltf/scene_gltf.h"

namespace gbl::test {

using Bytes = std::vector<uint8_t>;
using nlohmann::json;

// A file in the making: JSON that a test may bend at will, and one buffer.
struct GltfFile {
  json doc = {{"asset", {{"version", "2.0"}}}};
  Bytes buffer;

  int view(const Bytes&, int stride = 0);   // appended at a multiple of 4
  int add(const char* list, json element);  // its index
  int accessor(int view, size_t offset, int component_type, const char* type, size_t count, bool normalised = false);

  // Tightly packed numbers as an accessor.
  template <class T>
  int numbers(std::initializer_list<T> values, const char* type, bool normalised = false) {
    return numbers(std::vector<T>(values), type, normalised);
  }
  template <class T>
  int numbers(const std::vector<T>& values, const char* type, bool normalised = false) {
    Bytes bytes(values.size() * sizeof(T));
    if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    return accessor(view(bytes), 0, component_type<T>(), type, values.size() / components(type), normalised);
  }
  template <class T>
  static constexpr int component_type() {
    if constexpr (std::is_same_v<T, float>) return 5126;
    constexpr int kBase = sizeof(T) == 1 ? 5120 : sizeof(T) == 2 ? 5122 : 5124;
    return kBase + (std::is_unsigned_v<T> ? 1 : 0);
  }
  static size_t components(const std::string& type);

  // A mesh of one primitive on a node of its own in the scene; the node's index.
  int place(json primitive);
  json& node(int index) { return doc["nodes"][static_cast<size_t>(index)]; }

  std::string gltf() const;  // the buffer as a data URI
  Bytes glb() const;
  Scene load() const;  // as .glb from memory
};

// Three corners (0,0,0) (1,0,0) (0,1,0), on one node.
GltfFile triangle_file();
// The same with normals, uv (u right, v down: origin at the upper left), a texture of 2 x 2 and a material.
GltfFile textured_file();
json position_only(int position);  // a primitive

Bytes bytes_of(const std::string&);
std::string base64(const Bytes&);

// PNG of any kind: colour_type 0 grey, 2 RGB, 3 palette, 6 RGBA; rows: raw bytes, big-endian when 16 bits.
Bytes png(int width, int height, int bit_depth, int colour_type, const Bytes& rows, const Bytes& palette = {});
Bytes png_rgba(int width, int height, const Bytes& rgba);

// Load and give the error's text; "" if it loaded.
std::string refusal(const GltfFile&);
std::string refusal(const Bytes&);
bool has_warning(const Scene&, const std::string& part);

// Named small files, one per feature: seeds for mutation and fuzzing.
struct Seed {
  std::string name;
  Bytes bytes;
};
std::vector<Seed> seeds();

// A folder that disappears with it.
struct ScratchFolder {
  std::filesystem::path path;
  explicit ScratchFolder(const std::string& name);
  ~ScratchFolder();
  std::filesystem::path write(const std::string& name, const Bytes&) const;
};

}  // namespace gbl::test
