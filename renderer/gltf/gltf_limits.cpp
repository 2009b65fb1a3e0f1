#include "renderer/gltf/gltf_limits.h"

#include "renderer/gltf/gltf_json.h"
#include "renderer/gltf/scene_gltf.h"

namespace gbl {
namespace {

using namespace gltf;

constexpr Limit kLimits[] = {
    {"gltf-file-bytes", kMaxFileBytes, "bytes of one file"},
    {"gltf-all-file-bytes", kMaxAllFileBytes, "bytes of a model's files together"},
    {"gltf-json-depth", kMaxJsonDepth, "nesting of objects and lists in the JSON text"},
    {"gltf-json-values", kMaxJsonValues, "values in the JSON text"},
    {"gltf-elements", kMaxElements, "nodes, meshes, accessors or other elements in one list"},
    {"gltf-materials", kMaxMaterials, "materials, textures, images, samplers or skins"},
    {"gltf-instances", kMaxInstances, "primitives placed by nodes"},
    {"gltf-vertices", kMaxVertices, "vertices of all meshes"},
    {"gltf-triangles", kMaxTriangles, "triangles of all meshes"},
    {"gltf-drawn-triangles", kMaxDrawnTriangles, "triangles of all instances"},
    {"gltf-zero-elements", kMaxZeroElements, "elements of an accessor that has no data"},
    {"gltf-image-side", kMaxImageSide, "texels along one side of an image"},
    {"gltf-image-texels", kMaxImageTexels, "texels of one image"},
    {"gltf-texture-bytes", kMaxTextureBytes, "bytes of all decoded textures"},
    {"gltf-warnings", kMaxWarnings, "lines of warnings kept"},
    {"gltf-name-length", kMaxNameLength, "bytes of a name kept"},
};

}  // namespace

std::span<const Limit> gltf_limits() { return kLimits; }

}  // namespace gbl
