#include "renderer/gltf/scene_gltf.h"

#include <fmt/format.h>
#include <new>

#include "renderer/base/error.h"
#include "renderer/gltf/gltf_container.h"
#include "renderer/gltf/gltf_instances.h"
#include "renderer/gltf/gltf_limits.h"
#include "renderer/gltf/gltf_nodes.h"

namespace gbl {
namespace {

using namespace gltf;

// A .gltf's text can be let go once it is read; a .glb's buffer lies in its bytes.
Document open_document(Bytes& bytes, Folder& folder, Job& job) {
  const Container container = open_container(bytes, job);
  job.step("reading the structure", 0.05);
  TidyJson tidied = tidy_json(container.json, job);
  if (!container.has_binary) Bytes().swap(bytes);
  std::vector<Source> buffers = std::move(tidied.buffers);
  Document document = read_document(std::move(tidied), job);
  job.step("reading buffers", 0.15);
  load_buffers(document, buffers, container.binary, container.has_binary, folder, job);
  return document;
}

Scene build(Bytes bytes, const std::string& name, Folder folder, Job& job) {
  const Document document = open_document(bytes, folder, job);
  Scene scene;
  scene.name = clean_name(name);
  const std::vector<PlacedNode> placed = place_nodes(document, job);
  Materials materials(document, scene);
  add_instances(document, placed, materials, scene, job);
  if (scene.instances.empty() && !has_points_or_lines(document, placed)) {
    const std::vector<std::string> notes = job.take_notes();
    job.refuse(fmt::format("nothing drawable in it{}", notes.empty() ? "" : fmt::format(" ({})", notes.front())),
               "give a model whose scene holds a mesh of triangles");
  }
  if (document.scenes.size() > 1)
    job.note(fmt::format("it holds {} scenes: scene {} is shown", document.scenes.size(), document.scene));
  materials.decode_textures(folder, job);
  scene.bounds = bounds_of(scene);
  add_lights(document, placed, scene, job);
  set_camera(document, placed, scene, job);
  scene.warnings = job.take_notes();
  job.step("done", 1);
  return scene;
}

Scene load(Bytes bytes, const std::string& name, Folder folder, Job& job) {
  try {
    return build(std::move(bytes), name, std::move(folder), job);
  } catch (const std::bad_alloc&) {
    throw Error(ExitCode::unfinished, job.file(), "not enough memory to load it", "split or simplify the model");
  }
}

}  // namespace

Scene load_gltf(const std::filesystem::path& path, const LoadProgress* progress) {
  Job job(path.string(), progress);
  job.step("reading the file", 0);
  Bytes bytes;
  try {
    bytes = read_file(path, kMaxFileBytes);
  } catch (const Broken& broken) {
    job.refuse(broken.what(), "give a .gltf or .glb file");
  }
  const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  return load(std::move(bytes), path.stem().string(), Folder(folder), job);
}

Scene load_gltf_from_memory(std::span<const uint8_t> bytes, std::string_view name, const LoadProgress* progress) {
  Job job{std::string(name), progress};
  if (bytes.size() > kMaxFileBytes) job.refuse_limit("bytes", bytes.size(), kMaxFileBytes);
  return load(Bytes(bytes.begin(), bytes.end()), std::string(name), Folder(), job);
}

}  // namespace gbl
