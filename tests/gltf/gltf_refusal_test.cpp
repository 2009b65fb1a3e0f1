// Every class of broken file: refused in one line, or a part left out and said.
#include <functional>
#include <gtest/gtest.h>

#include "tests/gltf/gltf_fixture.h"

namespace gbl::test {
namespace {

TEST(GltfRefusal, BrokenJsonIsSaidWithoutTheLibrarysName) {
  const std::string refused = refusal(bytes_of("{\"asset\":"));
  EXPECT_NE(refused.find("broken JSON: parse error at line 1"), std::string::npos) << refused;
  EXPECT_EQ(refused.find("json.exception"), std::string::npos) << refused;
}

struct Case {
  const char* name;
  std::function<void(GltfFile&)> bend;
  const char* message;
};

json& primitive(GltfFile& f) { return f.doc["meshes"][0]["primitives"][0]; }
json& accessor(GltfFile& f) { return f.doc["accessors"][0]; }
json& view(GltfFile& f) { return f.doc["bufferViews"][0]; }

// The only mesh breaks: the refusal carries the reason.
const Case kRefused[] = {
    {"version 1", [](auto& f) { f.doc["asset"]["version"] = "1.0"; }, "glTF version '1.0'; export it as glTF 2.0"},
    {"minVersion", [](auto& f) { f.doc["asset"]["minVersion"] = "2.1"; }, "glTF version '2.1'"},
    {"no asset", [](auto& f) { f.doc.erase("asset"); }, "no 'asset' in it"},
    {"extension", [](auto& f) { f.doc["extensionsRequired"] = {"KHR_draco_mesh_compression"}; },
     "it requires the extension KHR_draco_mesh_compression; export it without; supported: KHR_lights_punctual, "
     "KHR_materials_emissive_strength, KHR_materials_ior, KHR_materials_specular, "
     "KHR_materials_transmission, KHR_materials_unlit, KHR_mesh_quantization, KHR_texture_transform"},
    {"no meshes", [](auto& f) { f.doc.erase("meshes"); }, "nothing drawable"},
    {"no scene nodes", [](auto& f) { f.doc["scenes"][0].erase("nodes"); }, "nothing drawable in it; give a model"},
    {"list", [](auto& f) { f.doc["meshes"] = 3; }, "'meshes' is not a list"},
    {"POSITION missing", [](auto& f) { primitive(f)["attributes"].erase("POSITION"); }, "'POSITION' is missing"},
    {"attributes missing", [](auto& f) { primitive(f).erase("attributes"); }, "'attributes' is missing"},
    {"accessor index", [](auto& f) { primitive(f)["attributes"]["POSITION"] = 9; },
     "meshes[0].primitives[0]: 'attributes' 'POSITION' is 9, but there are 1 accessors"},
    {"negative index", [](auto& f) { primitive(f)["attributes"]["POSITION"] = -1; }, "is -1, not a whole number"},
    {"huge index", [](auto& f) { primitive(f)["attributes"]["POSITION"] = 1e300; }, "not a whole number"},
    {"fraction", [](auto& f) { primitive(f)["attributes"]["POSITION"] = .5; }, "is 0.5, not a whole number"},
    {"text as index", [](auto& f) { primitive(f)["attributes"]["POSITION"] = "0"; }, "is not a number"},
    {"indices index", [](auto& f) { primitive(f)["indices"] = 4; }, "'indices' is 4, but there are 1 accessors"},
    {"index values",
     [](auto& f) {
       primitive(f)["indices"] = f.template numbers<uint8_t>({0, 1, 3}, "SCALAR");
     },
     "index 3 of 3 vertices"},
    {"index kind", [](auto& f) { primitive(f)["indices"] = 0; }, "its indices are not single numbers"},
    {"float indices",
     [](auto& f) {
       primitive(f)["indices"] = f.template numbers<float>({0, 1, 2}, "SCALAR");
     },
     "indices of component type 5126"},
    {"indices without data",
     [](auto& f) {
       primitive(f)["indices"] = f.add("accessors", {{"componentType", 5121}, {"count", 3}, {"type", "SCALAR"}});
     },
     "a primitive's indices have no data"},
    {"mode", [](auto& f) { primitive(f)["mode"] = 7; }, "mode 7 is not known"},
    {"too few", [](auto& f) { accessor(f)["count"] = 2; }, "fewer than 3 vertices"},
    {"none", [](auto& f) { accessor(f)["count"] = 0; }, "POSITION is empty or broken"},
    {"count", [](auto& f) { accessor(f)["count"] = 4; }, "run past the end of buffer view 0"},
    {"huge count", [](auto& f) { accessor(f)["count"] = 2147483647; }, "run past the end"},
    {"offset", [](auto& f) { accessor(f)["byteOffset"] = 4; }, "run past the end"},
    {"huge offset", [](auto& f) { accessor(f)["byteOffset"] = 9007199254740991; }, "run past the end"},
    {"component type", [](auto& f) { accessor(f)["componentType"] = 5130; }, "component type 5130"},
    {"double", [](auto& f) { accessor(f)["componentType"] = 5130; }, "accessors[0]: component type 5130"},
    {"shape", [](auto& f) { accessor(f)["type"] = "VEC7"; }, "as 'VEC7'"},
    {"wrong shape", [](auto& f) { accessor(f)["type"] = "VEC2"; }, "POSITION has 2 components"},
    {"view index", [](auto& f) { accessor(f)["bufferView"] = 5; }, "'bufferView' is 5, but there are 1 bufferViews"},
    {"view length", [](auto& f) { view(f)["byteLength"] = 4000000; }, "buffer view 0 runs past the end of buffer 0"},
    {"view offset", [](auto& f) { view(f)["byteOffset"] = 9007199254740991; }, "runs past the end"},
    {"stride", [](auto& f) { view(f)["byteStride"] = 7; }, "'byteStride' is 7"},
    {"long stride", [](auto& f) { view(f)["byteStride"] = 252; }, "run past the end"},
    {"buffer index", [](auto& f) { view(f)["buffer"] = 1; }, "'buffer' is 1, but there are 1 buffers"},
    {"no buffers", [](auto& f) { f.doc["buffers"] = json::array(); }, "but there are 0 buffers"},
    {"buffer length",
     [](auto& f) {
       f.doc["buffers"] = {{{"byteLength", 99}}};
     },
     "it should have 99 bytes, but has 36"},
    {"zeros", [](auto& f) { accessor(f).erase("bufferView"); }, "no triangle has an area"},
    {"zero bomb",
     [](auto& f) {
       accessor(f).erase("bufferView");
       accessor(f)["count"] = 2000000000;
     },
     "elements without data"},
    {"sparse count",
     [](auto& f) {
       accessor(f)["sparse"] = {
           {"count", 4}, {"indices", {{"bufferView", 0}, {"componentType", 5121}}}, {"values", {{"bufferView", 0}}}};
     },
     "4 sparse values for 3 elements"},
    {"sparse index",
     [](auto& f) {
       const int at = f.view({3});
       accessor(f)["sparse"] = {
           {"count", 1}, {"indices", {{"bufferView", at}, {"componentType", 5121}}}, {"values", {{"bufferView", 0}}}};
     },
     "sparse index 3 of 3 elements"},
    {"sparse parts",
     [](auto& f) {
       accessor(f)["sparse"] = {{"count", 1}};
     },
     "'sparse' 'indices' is missing"},
    {"attribute count",
     [](auto& f) {
       primitive(f)["attributes"]["TEXCOORD_0"] = f.template numbers<float>({0, 0}, "VEC2");
     },
     "TEXCOORD_0 has 1 elements for 3 vertices"},
    {"matrix", [](auto& f) { f.node(0)["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1e300, 0, 0, 1}; },
     "its transform is no usable matrix"},
    {"flat",
     [](auto& f) {
       f.node(0)["scale"] = {1, 0, 1};
     },
     "flattened by a scale of 0"},
    {"node's mesh", [](auto& f) { f.node(0)["mesh"] = 3; }, "nodes[0]: 'mesh' is 3, but there are 1 meshes; left out"},
    {"scene's node", [](auto& f) { f.doc["scenes"][0]["nodes"] = {8}; }, "an entry is 8, but there are 1 nodes"},
};

TEST(GltfRefusal, OneLineSaysWhy) {
  for (const Case& c : kRefused) {
    GltfFile file = triangle_file();
    c.bend(file);
    const std::string text = refusal(file);
    EXPECT_NE(text.find(c.message), std::string::npos) << c.name << ": '" << text << "'";
    EXPECT_EQ(text.substr(0, 6), "test: ") << c.name;
    EXPECT_EQ(text.find('\n'), std::string::npos) << c.name;
  }
}

// Beside a good mesh the bad one is left out, with a reason.
TEST(GltfRefusal, TheRestStands) {
  for (const Case& c : kRefused) {
    GltfFile file = triangle_file();
    c.bend(file);
    const bool one_mesh = refusal(file).find("primitive") != std::string::npos;
    if (!one_mesh) continue;
    const int good = file.numbers<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    file.place(position_only(good));
    const Scene scene = file.load();
    EXPECT_EQ(scene.instances.size(), 1u) << c.name;
    EXPECT_FALSE(scene.warnings.empty()) << c.name;
  }
}

const Case kNoted[] = {
    {"material", [](auto& f) { primitive(f)["material"] = 3; }, "'material' is 3, but there are 1 materials"},
    {"texture", [](auto& f) { f.doc["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 3; },
     "'baseColorTexture' 'index' is 3, but there are 1 textures; left out"},
    {"specular texture",
     [](auto& f) { f.doc["materials"][0]["extensions"]["KHR_materials_specular"]["specularTexture"]["index"] = 3; },
     "'specularTexture' 'index' is 3, but there are 1 textures; left out"},
    {"image", [](auto& f) { f.doc["textures"][0]["source"] = 2; }, "'source' is 2, but there are 1 images"},
    {"sampler", [](auto& f) { f.doc["textures"][0]["sampler"] = 2; }, "'sampler' is 2, but there are 0 samplers"},
    {"image's view", [](auto& f) { f.doc["images"][0]["bufferView"] = 77; }, "'bufferView' is 77"},
    {"image's bytes", [](auto& f) { f.doc["bufferViews"][3]["byteLength"] = 7777; }, "runs past the end of buffer 0"},
    {"camera", [](auto& f) { f.node(0)["camera"] = 0; }, "'camera' is 0, but there are 0 cameras"},
    {"skin", [](auto& f) { f.node(0)["skin"] = 0; }, "'skin' is 0, but there are 0 skins"},
    {"child", [](auto& f) { f.node(0)["children"] = {5}; }, "nodes[0].children: an entry is 5"},
    {"light", [](auto& f) { f.node(0)["extensions"]["KHR_lights_punctual"]["light"] = 0; }, "there are 0 lights"},
    {"light type",
     [](auto& f) {
       f.doc["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", 7}}};
       f.node(0)["extensions"]["KHR_lights_punctual"]["light"] = 0;
     },
     "lights[0]: 'type' is not a text"},
    {"joint",
     [](auto& f) {
       f.add("skins", {{"joints", {9}}});
       f.node(0)["skin"] = 0;
     },
     "skins[0]: 'joints' is 9"},
    {"factor",
     [](auto& f) {
       f.doc["materials"][0]["emissiveFactor"] = {1, 2};
     },
     "'emissiveFactor' is not a list of 3"},
    {"rotation",
     [](auto& f) {
       f.node(0)["rotation"] = {1, "x", 0, 0};
     },
     "'rotation' is not a list of 4 numbers"},
    {"uv set", [](auto& f) { f.doc["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 3; },
     "texture coordinates 3 are not read"},
    {"uv set past every int",
     [](auto& f) {
       f.doc["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = {
           {"KHR_texture_transform", {{"texCoord", 1e300}}}};
     },
     "'texCoord' is 1e+300, not a whole number"},
    {"alpha", [](auto& f) { f.doc["materials"][0]["alphaMode"] = "GLASS"; }, "unknown alphaMode"},
    {"no uv",
     [](auto& f) {
       f.doc["materials"][0]["normalTexture"] = {{"index", 0}};
       primitive(f)["attributes"].erase("TEXCOORD_0");
     },
     "a normal map, but no texture coordinates"},
    {"bad base64",
     [](auto& f) {
       f.doc["images"][0] = {{"uri", "data:image/png;base64,@@@"}};
     },
     "not base64"},
};

TEST(GltfRefusal, PartsAreLeftOutAndSaid) {
  for (const Case& c : kNoted) {
    GltfFile file = textured_file();
    c.bend(file);
    const Scene scene = file.load();
    EXPECT_TRUE(has_warning(scene, c.message)) << c.name << ": " << (scene.warnings.empty() ? "" : scene.warnings[0]);
    EXPECT_EQ(scene.instances.size(), 1u) << c.name;
  }
}

TEST(GltfRefusal, ContainersAndText) {
  Bytes glb = triangle_file().glb();
  EXPECT_NE(refusal(Bytes()).find("empty"), std::string::npos);
  EXPECT_NE(refusal(bytes_of("PK\x03\x04")).find("neither glTF JSON"), std::string::npos);
  EXPECT_NE(refusal(Bytes(glb.begin(), glb.begin() + 8)).find("ends in its header"), std::string::npos);
  EXPECT_NE(refusal(Bytes(glb.begin(), glb.end() - 1)).find("but ends after"), std::string::npos);
  Bytes bent = glb;
  bent[4] = 1;
  EXPECT_NE(refusal(bent).find("binary glTF of version 1"), std::string::npos);
  bent = glb;
  bent[15] = 0xff;
  EXPECT_NE(refusal(bent).find("chunk 0 should have"), std::string::npos);
  bent = glb;
  bent[16] = 'X';
  EXPECT_NE(refusal(bent).find("the first chunk is not JSON"), std::string::npos);
  EXPECT_NE(refusal(bytes_of("{\"asset\":")).find("broken JSON"), std::string::npos);
  EXPECT_NE(refusal(bytes_of("{\"asset\":{\"version\":\"2.0\"},\"x\":1e999}")).find("broken JSON"), std::string::npos);
  std::string deep = "{\"asset\":{\"version\":\"2.0\"},\"extras\":";
  deep += std::string(100000, '[') + std::string(100000, ']') + "}";
  EXPECT_NE(refusal(bytes_of(deep)).find("nested deeper than 64"), std::string::npos);
}

TEST(GltfRefusal, LimitsAreListed) {
  EXPECT_GE(gltf_limits().size(), 12u);
  for (const Limit& limit : gltf_limits()) EXPECT_GT(limit.value, 0u) << limit.id;
  GltfFile file = triangle_file();
  for (int i = 0; i < 20001; ++i) file.add("materials", json::object());
  EXPECT_NE(refusal(file).find("20001 materials, at most 20000 are read"), std::string::npos);
}

}  // namespace
}  // namespace gbl::test
