// libFuzzer target: any bytes end in a Scene or an Error. Built and run by scripts/fuzz_gltf.sh.
#include <cmath>
#include <cstdlib>

#include "renderer/base/error.h"
#include "renderer/gltf/scene_gltf.h"

namespace {

// What a renderer takes for granted; a failed check is a crash that the fuzzer keeps.
void demand(bool holds) {
  if (!holds) std::abort();
}

void demand_whole(const gbl::Scene& scene) {
  demand(!scene.instances.empty() && scene.camera.far > scene.camera.near);
  for (const gbl::Instance& i : scene.instances) {
    demand(static_cast<size_t>(i.mesh) < scene.meshes.size());
    demand(static_cast<size_t>(i.material) < scene.materials.size());
  }
  for (const gbl::Mesh& mesh : scene.meshes) {
    for (const uint32_t index : mesh.indices) demand(index < mesh.vertices.size());
    for (const gbl::Vertex& v : mesh.vertices) {
      demand(std::isfinite(v.position.x + v.position.y + v.position.z));
      demand(std::abs(glm::length(v.normal) - 1) < 1e-3f);
      demand(std::abs(glm::length(glm::vec3(v.tangent)) - 1) < 1e-3f);
    }
  }
  for (const gbl::Texture& t : scene.textures)
    demand(t.rgba.size() == static_cast<size_t>(t.size.x) * static_cast<size_t>(t.size.y) * 4);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  try {
    demand_whole(gbl::load_gltf_from_memory({data, size}, "fuzz"));
  } catch (const gbl::Error&) {
  }
  return 0;
}
