#pragma once
// The file's JSON, tidied: only members that the loader reads, each of the right type, each index in range.
// Whatever reads the result later (a library included) meets no surprise. What was taken out is noted.
#include <string>
#include <string_view>
#include <vector>

#include "renderer/gltf/gltf_job.h"

namespace gbl::gltf {

// A buffer's or an image's bytes: in a file, in the JSON, in a buffer view, or (buffer 0 of a .glb) in the container.
struct Source {
  std::string name;
  std::string uri;           // empty: none
  int view = -1;             // of an image
  uint64_t byte_length = 0;  // of a buffer
};

struct TidyJson {
  std::string text;  // without buffers and images
  std::vector<Source> buffers, images;
};

TidyJson tidy_json(std::string_view json, Job&);

}  // namespace gbl::gltf
