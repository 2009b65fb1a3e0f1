#pragma once
// What a glTF file may ask of us. Each is far above real models and far below what would exhaust a small machine.
#include <cstdint>

namespace gbl::gltf {

inline constexpr uint64_t kMaxFileBytes = 1ull << 30;
inline constexpr uint64_t kMaxAllFileBytes = 2ull << 30;
inline constexpr uint64_t kMaxJsonDepth = 64;                // real files: about 10
inline constexpr uint64_t kMaxJsonValues = 8'000'000;        // about 100 bytes of memory each
inline constexpr uint64_t kMaxElements = 250'000;            // in one array of the file: nodes, meshes, accessors …
inline constexpr uint64_t kMaxMaterials = 20'000;            // materials, textures, images, samplers, skins
inline constexpr uint64_t kMaxInstances = 250'000;           // (node, primitive) pairs
inline constexpr uint64_t kMaxVertices = 16'000'000;         // kept, of all meshes
inline constexpr uint64_t kMaxTriangles = 32'000'000;        // kept, of all meshes
inline constexpr uint64_t kMaxDrawnTriangles = 100'000'000;  // with repetitions
inline constexpr uint64_t kMaxZeroElements = 1'000'000;      // of an accessor without data: they cost the file nothing
inline constexpr uint64_t kMaxImageSide = 16'384;
inline constexpr uint64_t kMaxImageTexels = 1ull << 27;
inline constexpr uint64_t kMaxTextureBytes = 2ull << 30;  // decoded, of all textures
inline constexpr uint64_t kMaxWarnings = 100;             // lines; the rest is counted
inline constexpr uint64_t kMaxNameLength = 200;           // bytes; longer names are cut
// Positions beyond this overflow float when squared; matrices beyond it leave no digits for anything else.
inline constexpr double kMaxCoordinate = 1e18;

}  // namespace gbl::gltf
