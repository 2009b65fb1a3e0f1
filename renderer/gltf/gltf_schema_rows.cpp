// The rows: specification 5 (properties reference) and the extensions' own schemas.
#include <iterator>

#include "renderer/gltf/gltf_limits.h"
#include "renderer/gltf/gltf_schema.h"

namespace gbl::gltf {
namespace {

using enum Kind;
using enum Need;

constexpr Member kSparseIndices[] = {{"bufferView", Kind::index, required, 0, "bufferViews"},
                                     {"byteOffset", size, sound},
                                     {"componentType", size, required}};
constexpr Schema kSparseIndicesSchema{kSparseIndices, std::size(kSparseIndices)};
constexpr Member kSparseValues[] = {{"bufferView", Kind::index, required, 0, "bufferViews"},
                                    {"byteOffset", size, sound}};
constexpr Schema kSparseValuesSchema{kSparseValues, std::size(kSparseValues)};
constexpr Member kSparse[] = {{"count", size, required},
                              {"indices", object, required, 0, nullptr, &kSparseIndicesSchema},
                              {"values", object, required, 0, nullptr, &kSparseValuesSchema}};
constexpr Schema kSparseSchema{kSparse, std::size(kSparse)};

constexpr Member kAccessor[] = {{"bufferView", Kind::index, sound, 0, "bufferViews"},
                                {"byteOffset", size, sound},
                                {"componentType", size, required},
                                {"count", size, required},
                                {"normalized", flag, sound},
                                {"sparse", object, sound, 0, nullptr, &kSparseSchema},
                                {"type", text, required}};
constexpr Schema kAccessorSchema{kAccessor, std::size(kAccessor)};

constexpr Member kView[] = {{"buffer", Kind::index, required, 0, "buffers"},
                            {"byteLength", size, required},
                            {"byteOffset", size, sound},
                            {"byteStride", size, sound}};
constexpr Schema kViewSchema{kView, std::size(kView)};

constexpr Member kBuffer[] = {{"byteLength", size, required}, {"name", text}, {"uri", text, sound}};
constexpr Schema kBufferSchema{kBuffer, std::size(kBuffer)};

constexpr Member kImage[] = {
    {"bufferView", Kind::index, sound, 0, "bufferViews"}, {"name", text}, {"uri", text, sound}};
constexpr Schema kImageSchema{kImage, std::size(kImage)};

constexpr Member kAttributes[] = {
    {"COLOR_0", Kind::index, sound, 0, "accessors"},    {"JOINTS_0", Kind::index, sound, 0, "accessors"},
    {"NORMAL", Kind::index, sound, 0, "accessors"},     {"POSITION", Kind::index, required, 0, "accessors"},
    {"TANGENT", Kind::index, sound, 0, "accessors"},    {"TEXCOORD_0", Kind::index, sound, 0, "accessors"},
    {"TEXCOORD_1", Kind::index, sound, 0, "accessors"}, {"WEIGHTS_0", Kind::index, sound, 0, "accessors"}};
constexpr Schema kAttributesSchema{kAttributes, std::size(kAttributes)};
constexpr Member kPrimitive[] = {{"attributes", object, required, 0, nullptr, &kAttributesSchema},
                                 {"indices", Kind::index, sound, 0, "accessors"},
                                 {"material", Kind::index, optional, 0, "materials"},
                                 {"mode", size, sound}};
constexpr Schema kPrimitiveSchema{kPrimitive, std::size(kPrimitive)};
constexpr Member kMesh[] = {{"name", text}, {"primitives", objects, required, 0, nullptr, &kPrimitiveSchema}};
constexpr Schema kMeshSchema{kMesh, std::size(kMesh)};

constexpr Member kNodeLight[] = {{"light", size, required}};
constexpr Schema kNodeLightSchema{kNodeLight, std::size(kNodeLight)};
constexpr Member kNodeExtensions[] = {{"KHR_lights_punctual", object, optional, 0, nullptr, &kNodeLightSchema}};
constexpr Schema kNodeExtensionsSchema{kNodeExtensions, std::size(kNodeExtensions)};
constexpr Member kNode[] = {{"camera", Kind::index, optional, 0, "cameras"},
                            {"children", indices, optional, 0, "nodes"},
                            {"extensions", object, optional, 0, nullptr, &kNodeExtensionsSchema},
                            {"matrix", numbers, optional, 16},
                            {"mesh", Kind::index, optional, 0, "meshes"},
                            {"name", text},
                            {"rotation", numbers, optional, 4},
                            {"scale", numbers, optional, 3},
                            {"skin", Kind::index, optional, 0, "skins"},
                            {"translation", numbers, optional, 3}};
constexpr Schema kNodeSchema{kNode, std::size(kNode)};
constexpr Member kScene[] = {{"name", text}, {"nodes", indices, optional, 0, "nodes"}};
constexpr Schema kSceneSchema{kScene, std::size(kScene)};
constexpr Member kSkin[] = {{"inverseBindMatrices", Kind::index, sound, 0, "accessors"},
                            {"joints", indices, required, 0, "nodes"},
                            {"name", text}};
constexpr Schema kSkinSchema{kSkin, std::size(kSkin)};

constexpr Member kTransform[] = {
    {"offset", numbers, optional, 2}, {"rotation", number}, {"scale", numbers, optional, 2}, {"texCoord", size}};
constexpr Schema kTransformSchema{kTransform, std::size(kTransform)};
constexpr Member kUseExtensions[] = {{"KHR_texture_transform", object, optional, 0, nullptr, &kTransformSchema}};
constexpr Schema kUseExtensionsSchema{kUseExtensions, std::size(kUseExtensions)};
constexpr Member kUse[] = {{"extensions", object, optional, 0, nullptr, &kUseExtensionsSchema},
                           {"index", Kind::index, required, 0, "textures"},
                           {"scale", number},     // of a normal map
                           {"strength", number},  // of occlusion
                           {"texCoord", size}};
constexpr Schema kUseSchema{kUse, std::size(kUse)};
constexpr Member kMetallicRoughness[] = {{"baseColorFactor", numbers, optional, 4},
                                         {"baseColorTexture", object, optional, 0, nullptr, &kUseSchema},
                                         {"metallicFactor", number},
                                         {"metallicRoughnessTexture", object, optional, 0, nullptr, &kUseSchema},
                                         {"roughnessFactor", number}};
constexpr Schema kMetallicRoughnessSchema{kMetallicRoughness, std::size(kMetallicRoughness)};
constexpr Member kStrength[] = {{"emissiveStrength", number}};
constexpr Schema kStrengthSchema{kStrength, std::size(kStrength)};
constexpr Member kIndexOfRefraction[] = {{"ior", number}};
constexpr Schema kIndexOfRefractionSchema{kIndexOfRefraction, std::size(kIndexOfRefraction)};
constexpr Member kSpecular[] = {{"specularColorFactor", numbers, optional, 3},
                                {"specularColorTexture", object, optional, 0, nullptr, &kUseSchema},
                                {"specularFactor", number},
                                {"specularTexture", object, optional, 0, nullptr, &kUseSchema}};
constexpr Schema kSpecularSchema{kSpecular, std::size(kSpecular)};
constexpr Member kTransmission[] = {{"transmissionFactor", number},
                                    {"transmissionTexture", object, optional, 0, nullptr, &kUseSchema}};
constexpr Schema kTransmissionSchema{kTransmission, std::size(kTransmission)};
constexpr Schema kNothingSchema{nullptr, 0};
constexpr Member kMaterialExtensions[] = {
    {"KHR_materials_emissive_strength", object, optional, 0, nullptr, &kStrengthSchema},
    {"KHR_materials_ior", object, optional, 0, nullptr, &kIndexOfRefractionSchema},
    {"KHR_materials_specular", object, optional, 0, nullptr, &kSpecularSchema},
    {"KHR_materials_transmission", object, optional, 0, nullptr, &kTransmissionSchema},
    {"KHR_materials_unlit", object, optional, 0, nullptr, &kNothingSchema}};
constexpr Schema kMaterialExtensionsSchema{kMaterialExtensions, std::size(kMaterialExtensions)};
constexpr Member kMaterial[] = {{"alphaCutoff", number},
                                {"alphaMode", text},
                                {"doubleSided", flag},
                                {"emissiveFactor", numbers, optional, 3},
                                {"emissiveTexture", object, optional, 0, nullptr, &kUseSchema},
                                {"extensions", object, optional, 0, nullptr, &kMaterialExtensionsSchema},
                                {"name", text},
                                {"normalTexture", object, optional, 0, nullptr, &kUseSchema},
                                {"occlusionTexture", object, optional, 0, nullptr, &kUseSchema},
                                {"pbrMetallicRoughness", object, optional, 0, nullptr, &kMetallicRoughnessSchema}};
constexpr Schema kMaterialSchema{kMaterial, std::size(kMaterial)};
constexpr Member kTexture[] = {
    {"name", text}, {"sampler", Kind::index, optional, 0, "samplers"}, {"source", Kind::index, optional, 0, "images"}};
constexpr Schema kTextureSchema{kTexture, std::size(kTexture)};
constexpr Member kSampler[] = {{"magFilter", size}, {"minFilter", size}, {"wrapS", size}, {"wrapT", size}};
constexpr Schema kSamplerSchema{kSampler, std::size(kSampler)};

constexpr Member kPerspective[] = {
    {"aspectRatio", number}, {"yfov", number, required}, {"zfar", number, sound}, {"znear", number, required}};
constexpr Schema kPerspectiveSchema{kPerspective, std::size(kPerspective)};
constexpr Member kOrthographic[] = {
    {"xmag", number, required}, {"ymag", number, required}, {"zfar", number, required}, {"znear", number, required}};
constexpr Schema kOrthographicSchema{kOrthographic, std::size(kOrthographic)};
constexpr Member kCamera[] = {{"orthographic", object, sound, 0, nullptr, &kOrthographicSchema},
                              {"perspective", object, sound, 0, nullptr, &kPerspectiveSchema},
                              {"type", text, required}};
constexpr Schema kCameraSchema{kCamera, std::size(kCamera)};

constexpr Member kSpot[] = {{"innerConeAngle", number}, {"outerConeAngle", number}};
constexpr Schema kSpotSchema{kSpot, std::size(kSpot)};
constexpr Member kLight[] = {{"color", numbers, optional, 3},
                             {"intensity", number},
                             {"name", text},
                             {"range", number, optional},
                             {"spot", object, optional, 0, nullptr, &kSpotSchema},
                             {"type", text, required}};
constexpr Schema kLightSchema{kLight, std::size(kLight)};

// The stand-in of a light keeps the library content; its kind is unknown to us and shines nowhere.
constexpr Section kLights{"lights", R"({"type":"none"})", &kLightSchema, kMaxElements};

constexpr Section kSections[] = {
    {"accessors", R"({"componentType":5126,"count":0,"type":"SCALAR"})", &kAccessorSchema, kMaxElements},
    {"bufferViews", R"({"buffer":0,"byteLength":0})", &kViewSchema, kMaxElements},
    {"buffers", R"({"byteLength":0})", &kBufferSchema, kMaxMaterials},
    {"cameras", R"({"type":"perspective","perspective":{"yfov":0,"znear":0}})", &kCameraSchema, kMaxMaterials},
    {"images", "{}", &kImageSchema, kMaxMaterials},
    {"materials", "{}", &kMaterialSchema, kMaxMaterials},
    {"meshes", R"({"primitives":[]})", &kMeshSchema, kMaxElements},
    {"nodes", "{}", &kNodeSchema, kMaxElements},
    {"samplers", "{}", &kSamplerSchema, kMaxMaterials},
    {"scenes", "{}", &kSceneSchema, kMaxElements},
    {"skins", R"({"joints":[]})", &kSkinSchema, kMaxMaterials},
    {"textures", "{}", &kTextureSchema, kMaxMaterials},
};

}  // namespace

const Section* sections(size_t& count) {
  count = std::size(kSections);
  return kSections;
}

const Section& lights_section() { return kLights; }

}  // namespace gbl::gltf
