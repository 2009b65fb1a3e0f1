#include "renderer/gltf/gltf_materials.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/gltf/gltf_decode.h"

namespace gbl::gltf {

int Materials::use(int index) {
  const auto [entry, is_new] = materials_.emplace(index, static_cast<int>(scene_.materials.size()));
  if (!is_new) return entry->second;
  Material material;
  if (index >= 0) {
    material = document_.materials[static_cast<size_t>(index)];
  } else {
    material.name = "default";
    material.metal = 1;
  }
  for (TextureUse* texture : texture_uses(material)) use_texture(*texture);
  scene_.materials.push_back(std::move(material));
  return entry->second;
}

TangentNeed Materials::tangent_need(int index) const {
  if (index < 0) return {};
  const TextureUse& normal = document_.materials[static_cast<size_t>(index)].normal_texture;
  return {normal.texture != kNoTexture, normal.uv_set, normal.uv_transform};
}

void Materials::use_texture(TextureUse& use) {
  if (use.texture == kNoTexture) return;
  const TextureSource& source = document_.textures[static_cast<size_t>(use.texture)];
  std::vector<int>& of_image = textures_of_image_[source.image];  // few: one per sampler
  const auto same = std::find_if(of_image.begin(), of_image.end(), [&](int texture) {
    return scene_.textures[static_cast<size_t>(texture)].sampler == source.sampler;
  });
  if (same != of_image.end()) {
    use.texture = *same;
    return;
  }
  use.texture = static_cast<int>(scene_.textures.size());
  of_image.push_back(use.texture);
  Texture texture;
  texture.sampler = source.sampler;
  scene_.textures.push_back(std::move(texture));
}

void Materials::decode_textures(Folder& folder, Job& job) {
  std::vector<ImageJob> images;
  for (const auto& [image, textures] : textures_of_image_) images.push_back({image, textures});
  decode_images(document_, std::move(images), scene_, folder, job);
}

}  // namespace gbl::gltf
