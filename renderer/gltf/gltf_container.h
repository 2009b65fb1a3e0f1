#pragma once
// Where the JSON text and the binary chunk lie in a file's bytes. Arithmetic only; nothing is copied.
#include <cstdint>
#include <span>
#include <string_view>

#include "renderer/gltf/gltf_job.h"

namespace gbl::gltf {

struct Container {
  std::string_view json;
  std::span<const uint8_t> binary;  // of a .glb; empty if there is none
  bool has_binary = false;
};

// By the first bytes, not by the file's name. (Specification 4: GLB file format.)
Container open_container(std::span<const uint8_t> bytes, const Job&);

// Nesting and number of values, before a parser that recurses or allocates sees the text.
void check_json_shape(std::string_view json, const Job&);

}  // namespace gbl::gltf
