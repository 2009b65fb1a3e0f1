#pragma once
// The scene's materials and textures: those that something drawn uses, each once.
#include <map>
#include <utility>
#include <vector>

#include "renderer/gltf/gltf_document.h"
#include "renderer/gltf/gltf_primitive.h"

namespace gbl::gltf {

class Materials {
 public:
  Materials(const Document& document, Scene& scene) : document_(document), scene_(scene) {}

  // The scene's index of a material of the file; -1: the specification's default material (3.7.2.1).
  int use(int index);
  TangentNeed tangent_need(int index) const;

  // Fills the textures that were used, on all processors. What cannot be decoded becomes a magenta checker.
  void decode_textures(Folder&, Job&);

 private:
  void use_texture(TextureUse&);

  const Document& document_;
  Scene& scene_;
  std::map<int, int> materials_;                       // file -> scene
  std::map<int, std::vector<int>> textures_of_image_;  // image (-1: none) -> textures of the scene, one per sampler
};

}  // namespace gbl::gltf
