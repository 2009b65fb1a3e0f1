// One small file per feature.
#include "tests/gltf/gltf_fixture.h"

namespace gbl::test {
namespace {

GltfFile skinned_file() {
  GltfFile file = triangle_file();
  json& attributes = file.doc["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] = file.numbers<uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4");
  attributes["WEIGHTS_0"] = file.numbers<float>({1, 0, 0, 0, 1, 0, 0, 0, .5f, .5f, 0, 0}, "VEC4");
  std::vector<float> bind(32, 0.f);
  for (size_t m = 0; m < 2; ++m)
    for (size_t e = 0; e < 16; ++e) bind[16 * m + e] = e % 5 == 0 ? 1.f : 0.f;
  const int root = file.add("nodes", {{"children", {2}}, {"translation", {0, 0, 5}}});
  file.add("nodes", {{"translation", {0, 1, 0}}});
  file.add("skins", {{"joints", {1, 2}}, {"inverseBindMatrices", file.numbers(bind, "MAT4")}});
  file.node(0)["skin"] = 0;
  file.doc["scenes"][0]["nodes"].push_back(root);
  return file;
}

GltfFile lit_file() {
  GltfFile file = triangle_file();
  const json lights = {{{"type", "point"}, {"range", 4}},
                       {{"type", "spot"}, {"spot", {{"innerConeAngle", .1}, {"outerConeAngle", .5}}}},
                       {{"type", "directional"}, {"color", {1, .5, 0}}, {"intensity", 2}}};
  file.doc["extensions"]["KHR_lights_punctual"]["lights"] = lights;
  file.doc["extensionsUsed"] = {"KHR_lights_punctual"};
  file.node(0)["extensions"]["KHR_lights_punctual"]["light"] = 1;
  file.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", .7}, {"znear", .1}}}});
  file.node(0)["camera"] = 0;
  return file;
}

GltfFile sparse_file() {
  GltfFile file = triangle_file();
  const int indices = file.view({0, 2}),
            values = file.view(Bytes{0, 0, 64, 64, 0, 0, 64, 64, 0, 0, 64, 64, 0, 0, 0, 65, 0, 0, 64, 65, 0, 0, 0, 65});
  file.doc["accessors"][0]["sparse"] = {{"count", 2},
                                        {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                                        {"values", {{"bufferView", values}}}};
  return file;
}

GltfFile rich_material_file() {
  GltfFile file = textured_file();
  json& material = file.doc["materials"][0];
  const json transform = {{"offset", {.5, 0}}, {"rotation", .3}, {"scale", {2, 2}}, {"texCoord", 0}};
  material["normalTexture"] = {{"index", 0}, {"scale", .5}, {"extensions", {{"KHR_texture_transform", transform}}}};
  material["occlusionTexture"] = {{"index", 0}, {"strength", .5}};
  material["emissiveTexture"] = {{"index", 0}};
  material["emissiveFactor"] = {1, .5, .25};
  material["extensions"] = {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}},
                            {"KHR_materials_ior", {{"ior", 1.33}}},
                            {"KHR_materials_specular",
                             {{"specularFactor", .5},
                              {"specularTexture", {{"index", 0}}},
                              {"specularColorFactor", {1, .5, .25}},
                              {"specularColorTexture", {{"index", 0}}}}},
                            {"KHR_materials_unlit", json::object()}};
  material["alphaMode"] = "MASK";
  file.add("samplers", {{"wrapS", 33071}, {"minFilter", 9728}});
  file.doc["textures"][0]["sampler"] = 0;
  return file;
}

GltfFile strip_file() {
  GltfFile file;
  const int position = file.numbers<int16_t>({0, 0, 0, 0, 9, 0, 0, 0, 0, 9, 0, 0, 9, 9, 0, 0}, "VEC4");
  file.doc["accessors"][0]["type"] = "VEC3";
  file.doc["bufferViews"][0]["byteStride"] = 8;
  json primitive = position_only(position);
  primitive["indices"] = file.numbers<uint16_t>({0, 1, 2, 3}, "SCALAR");
  primitive["mode"] = 5;
  file.place(primitive);
  return file;
}

}  // namespace

std::vector<Seed> seeds() {
  std::vector<Seed> all = {{"triangle.glb", triangle_file().glb()}, {"textured.glb", textured_file().glb()},
                           {"skinned.glb", skinned_file().glb()},   {"lit.glb", lit_file().glb()},
                           {"sparse.glb", sparse_file().glb()},     {"material.glb", rich_material_file().glb()},
                           {"strip.glb", strip_file().glb()}};
  all.push_back({"textured.gltf", bytes_of(textured_file().gltf())});
  all.push_back({"material.gltf", bytes_of(rich_material_file().gltf())});
  all.push_back({"skinned.gltf", bytes_of(skinned_file().gltf())});
  return all;
}

}  // namespace gbl::test
