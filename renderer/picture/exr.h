#pragma once
// Numbers of a picture as an OpenEXR file: 32-bit floats, or whole numbers, in channels with names.
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

namespace gbl {

struct ExrChannel {
  std::string name;           // "R", "depth.Z"
  std::vector<float> values;  // rows top to bottom
  bool whole = false;         // kept as 32-bit unsigned integers
};

// Written whole or not at all; Error(unfinished) if the folder cannot be written. texts: (name, text) attributes.
void write_exr(const std::filesystem::path&, glm::ivec2 size, const std::vector<ExrChannel>&,
               const std::vector<std::pair<std::string, std::string>>& texts = {});

struct ExrPicture {
  glm::ivec2 size{0};
  std::vector<glm::vec3> rgb;  // rows top to bottom, as they are stored
};
ExrPicture read_exr(const std::filesystem::path&);  // its R, G and B; Error(bad_input)

}  // namespace gbl
