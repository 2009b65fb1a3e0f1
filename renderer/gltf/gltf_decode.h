#pragma once
// Images of a document into textures of a scene, on all processors.
#include <vector>

#include "renderer/gltf/gltf_document.h"

namespace gbl::gltf {

struct ImageJob {
  int image = -1;             // of the document; -1: the file names none
  std::vector<int> textures;  // of the scene: one per sampler
};

void decode_images(const Document&, std::vector<ImageJob>, Scene&, Folder&, Job&);

// What stands for a texture that cannot be shown: nobody takes it for a surface.
void fill_placeholder(Texture&);

}  // namespace gbl::gltf
