#pragma once
// glTF 2.0 files (.gltf, .glb) as scenes. No GL. ("The specification" below: Khronos 2021, "glTF 2.0 Specification",
// version 2.0.1.)
//
// A file that cannot be shown is one Error(bad_input) that names the file, the place in it and the fix: not glTF 2.0,
// an extension it requires and we lack, a limit exceeded, broken JSON or container, nothing drawable.
// A broken part of a file is left out and said in Scene.warnings, while the rest stands: a bad mesh is not drawn, a bad
// image is a magenta checker, a bad node hangs nowhere. What we do not draw is said there too, once each: animations,
// morph targets, points and lines. Skinned meshes stand in their rest pose.
// Files are read below the model's own folder only, never through a link that leads outside.
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>

#include "renderer/base/limits.h"
#include "renderer/scene/scene.h"

namespace gbl {

// Called from the loading thread only; `cancelled` may be set from any.
struct LoadProgress {
  std::function<void(std::string_view stage, double fraction)> report;  // fraction grows from 0 to 1
  std::atomic<bool> cancelled{false};                                   // then loading ends in Error(interrupted)
};

Scene load_gltf(const std::filesystem::path&, const LoadProgress* = nullptr);

// From bytes of either kind; no other file is read. name: for messages and as the scene's name.
Scene load_gltf_from_memory(std::span<const uint8_t> bytes, std::string_view name, const LoadProgress* = nullptr);

std::span<const Limit> gltf_limits();                   // what a file may ask for
std::span<const std::string_view> gltf_extensions();    // those a file may require
inline constexpr double kGltfFarOfEndlessCamera = 1e4;  // far of a camera without one: at least this times near

}  // namespace gbl
