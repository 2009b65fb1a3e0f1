#include <cmath>
#include <fstream>
#include <gtest/gtest.h>

#include "tests/gltf/gltf_fixture.h"

namespace gbl::test {
namespace {

const Bytes kTwoByTwo = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 8, 7, 6};

glm::vec2 apply(const glm::mat3& m, glm::vec2 uv) { return glm::vec2(m * glm::vec3(uv, 1)); }

bool is_checker(const Texture& texture) {
  return texture.size == glm::ivec2(8) && texture.rgba.at(0) == 255 && texture.rgba.at(1) == 0 &&
         texture.rgba.at(4) == 0;
}

// The textured file with its image replaced.
Scene with_image(const Bytes& encoded) {
  GltfFile file = textured_file();
  file.doc["images"][0]["bufferView"] = file.view(encoded);
  return file.load();
}

TEST(GltfMaterial, TexelsAndTangentsOfTheTexturedTriangle) {
  GltfFile file = textured_file();
  file.doc["materials"][0]["normalTexture"] = {{"index", 0}, {"scale", .25}};
  const Scene scene = file.load();
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.textures[0].rgba, kTwoByTwo);
  EXPECT_EQ(scene.materials[0].normal_scale, .25f);
  EXPECT_EQ(scene.materials[0].base_colour_texture.texture, 0);
  for (const Vertex& v : scene.meshes[0].vertices) EXPECT_EQ(v.tangent, glm::vec4(1, 0, 0, 1));
}

TEST(GltfMaterial, DefaultsAreTheSpecifications) {
  GltfFile file = triangle_file();
  const Material bare = file.load().materials.at(0);
  EXPECT_EQ(bare.metal, 1);
  EXPECT_EQ(bare.roughness, 1);
  EXPECT_EQ(bare.alpha_mode, AlphaMode::opaque);
  EXPECT_FALSE(bare.double_sided);
  file.add("materials", json::object());
  file.doc["meshes"][0]["primitives"][0]["material"] = 0;
  const Material empty = file.load().materials.at(0);
  EXPECT_EQ(empty.metal, 1);
  EXPECT_EQ(empty.base_colour, glm::vec4(1));
  EXPECT_EQ(empty.emissive, glm::vec3(0));
  EXPECT_EQ(empty.alpha_cutoff, .5f);
}

TEST(GltfMaterial, EveryFactor) {
  GltfFile file = textured_file();
  file.doc["materials"][0] = {
      {"name", "paint"},
      {"pbrMetallicRoughness",
       {{"baseColorFactor", {.5, .25, .125, .75}}, {"metallicFactor", .25}, {"roughnessFactor", .5}}},
      {"emissiveFactor", {1, .5, 0}},
      {"occlusionTexture", {{"index", 0}, {"strength", .5}, {"texCoord", 1}}},
      {"emissiveTexture", {{"index", 0}}},
      {"alphaMode", "MASK"},
      {"alphaCutoff", .25},
      {"doubleSided", true},
      {"extensions",
       {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}, {"KHR_materials_unlit", json::object()}}}};
  file.doc["extensionsRequired"] = {"KHR_materials_unlit", "KHR_materials_emissive_strength"};
  const Material m = file.load().materials.at(0);
  EXPECT_EQ(m.name, "paint");
  EXPECT_EQ(m.base_colour, glm::vec4(.5f, .25f, .125f, .75f));
  EXPECT_EQ(m.metal, .25f);
  EXPECT_EQ(m.roughness, .5f);
  EXPECT_EQ(m.emissive, glm::vec3(4, 2, 0));
  EXPECT_EQ(m.occlusion_strength, .5f);
  EXPECT_EQ(m.occlusion_texture.uv_set, 1);
  EXPECT_EQ(m.occlusion_texture.texture, m.emissive_texture.texture);
  EXPECT_EQ(m.alpha_mode, AlphaMode::mask);
  EXPECT_EQ(m.alpha_cutoff, .25f);
  EXPECT_TRUE(m.double_sided);
  EXPECT_TRUE(m.unlit);
}

TEST(GltfMaterial, ReflectanceOfNonMetals) {
  GltfFile file = textured_file();
  json& material = file.doc["materials"][0];
  EXPECT_TRUE(reflects_as_common(file.load().materials.at(0)));
  file.doc["extensionsRequired"] = {"KHR_materials_ior", "KHR_materials_specular"};
  const json shift = {{"KHR_texture_transform", {{"offset", {.5, .25}}, {"texCoord", 1}}}};
  material["extensions"] = {{"KHR_materials_ior", {{"ior", 1.33}}},
                            {"KHR_materials_specular",
                             {{"specularFactor", .5},
                              {"specularTexture", {{"index", 0}, {"texCoord", 1}}},
                              {"specularColorFactor", {2, .5, .25}},
                              {"specularColorTexture", {{"index", 0}, {"extensions", shift}}}}}};
  const Material m = file.load().materials.at(0);
  EXPECT_EQ(m.refraction_index, 1.33f);
  EXPECT_EQ(m.specular, .5f);
  EXPECT_EQ(m.specular_colour, glm::vec3(2, .5f, .25f));
  EXPECT_EQ(m.specular_texture.texture, m.base_colour_texture.texture);
  EXPECT_EQ(m.specular_texture.uv_set, 1);
  EXPECT_EQ(m.specular_colour_texture.texture, m.base_colour_texture.texture);
  EXPECT_EQ(m.specular_colour_texture.uv_set, 1);
  EXPECT_EQ(apply(m.specular_colour_texture.uv_transform, {0, 0}), glm::vec2(.5f, .25f));
  EXPECT_FALSE(reflects_as_common(m));
  for (const auto& [index, read] : {std::pair{0.0, 0.0f}, {0.5, 1.0f}, {-3.0, 1.0f}, {1.0, 1.0f}, {2.4, 2.4f}}) {
    material["extensions"] = {{"KHR_materials_ior", {{"ior", index}}}};
    EXPECT_EQ(file.load().materials.at(0).refraction_index, read) << index;
  }
}

TEST(GltfMaterial, TransmissionIsHowMuchGoesThrough) {
  GltfFile file = textured_file();
  json& material = file.doc["materials"][0];
  EXPECT_EQ(file.load().materials.at(0).transmission, 0);
  file.doc["extensionsRequired"] = {"KHR_materials_transmission"};
  for (const auto& [factor, read] : {std::pair{0.75, 0.75f}, {-1.0, 0.0f}, {7.0, 1.0f}}) {
    material["extensions"] = {{"KHR_materials_transmission", {{"transmissionFactor", factor}}}};
    EXPECT_EQ(file.load().materials.at(0).transmission, read) << factor;
  }
  material["extensions"]["KHR_materials_transmission"]["transmissionTexture"] = {{"index", 0}};
  const std::vector<std::string> warnings = file.load().warnings;
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string& w) {
    return w.find("transmission texture is not read") != std::string::npos;
  }));
}

TEST(GltfMaterial, TextureTransformTurnsCounterClockwiseAsSeen) {
  GltfFile file = textured_file();
  json& use = file.doc["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
  use["extensions"]["KHR_texture_transform"] = {{"offset", {.5, .25}}, {"scale", {2, 3}}, {"texCoord", 1}};
  const TextureUse scaled = file.load().materials.at(0).base_colour_texture;
  EXPECT_EQ(apply(scaled.uv_transform, {1, 1}), glm::vec2(2.5f, 3.25f));
  EXPECT_EQ(scaled.uv_set, 1);
  use["extensions"]["KHR_texture_transform"] = {{"rotation", std::acos(0.)}};
  const glm::vec2 right = apply(file.load().materials.at(0).base_colour_texture.uv_transform, {1, 0});
  EXPECT_NEAR(right.x, 0, 1e-6);  // v points down: up is -1
  EXPECT_NEAR(right.y, -1, 1e-6);
}

TEST(GltfMaterial, SamplersAndSharing) {
  GltfFile file = textured_file();
  file.add("samplers", {{"wrapS", 33071}, {"wrapT", 33648}, {"minFilter", 9985}, {"magFilter", 9728}});
  file.add("textures", {{"source", 0}, {"sampler", 0}});
  file.add("textures", {{"source", 0}});  // again the first pair
  json& material = file.doc["materials"][0];
  material["emissiveTexture"] = {{"index", 1}};
  material["normalTexture"] = {{"index", 2}};
  const Scene scene = file.load();
  ASSERT_EQ(scene.textures.size(), 2u);
  EXPECT_EQ(scene.materials[0].normal_texture.texture, scene.materials[0].base_colour_texture.texture);
  const Texture& other = scene.textures.at(static_cast<size_t>(scene.materials[0].emissive_texture.texture));
  EXPECT_EQ(other.sampler, (Sampler{Wrap::clamp, Wrap::mirror, Filter::linear_mipmap_nearest, Filter::nearest}));
  EXPECT_EQ(other.rgba, kTwoByTwo);
}

TEST(GltfMaterial, ImagesOfManyKinds) {
  EXPECT_EQ(with_image(png(2, 1, 8, 0, {7, 200})).textures.at(0).rgba, (Bytes{7, 7, 7, 255, 200, 200, 200, 255}));
  EXPECT_EQ(with_image(png(1, 1, 8, 2, {1, 2, 3})).textures.at(0).rgba, (Bytes{1, 2, 3, 255}));
  EXPECT_EQ(with_image(png(2, 1, 8, 3, {1, 0}, {9, 8, 7, 1, 2, 3})).textures.at(0).rgba,
            (Bytes{1, 2, 3, 255, 9, 8, 7, 255}));
  const Texture deep = with_image(png(1, 1, 16, 6, {10, 1, 20, 2, 30, 3, 40, 4})).textures.at(0);
  EXPECT_TRUE(deep.rgba.empty());
  EXPECT_EQ(deep.rgba16, (std::vector<uint16_t>{0x0a01, 0x1402, 0x1e03, 0x2804})) << "16 bits stay 16 bits";
}

TEST(GltfMaterial, BadImagesAreCheckersAndSaidWhileTheRestStands) {
  const Bytes good = png_rgba(2, 2, kTwoByTwo);
  const std::vector<std::pair<Bytes, std::string>> bad = {
      {bytes_of("no picture at all"), "neither PNG nor JPEG"},
      {Bytes(good.begin(), good.begin() + 40), "cannot be decoded"},
      {png(20000, 20000, 8, 6, {}), "neither PNG nor JPEG"},  // stb refuses the side before we do
      {png(16000, 16000, 8, 6, {}), "16000 x 16000 texels"},
      {png(0, 0, 8, 6, {}), "neither PNG nor JPEG"},
  };
  for (const auto& [bytes, message] : bad) {
    const Scene scene = with_image(bytes);
    EXPECT_TRUE(is_checker(scene.textures.at(0))) << message;
    EXPECT_TRUE(has_warning(scene, message)) << scene.warnings.at(0);
    EXPECT_EQ(scene.instances.size(), 1u);
  }
  GltfFile none = textured_file();
  none.doc["textures"][0].erase("source");
  EXPECT_TRUE(has_warning(none.load(), "names no image"));
}

TEST(GltfMaterial, UrisOfEveryKind) {
  const ScratchFolder folder("uris");
  const Bytes picture = png_rgba(2, 2, kTwoByTwo);
  folder.write("my picture \xc3\xa9.png", picture);
  GltfFile file = textured_file();
  file.doc["images"][0].erase("bufferView");
  std::filesystem::create_directory(folder.path / "sub");
  std::filesystem::copy(folder.path / "my picture \xc3\xa9.png", folder.path / "sub/x.png");
  for (const char* uri : {"my%20picture%20%C3%A9.png", "my picture \xc3\xa9.png", "./sub/x.png", "sub/x.png"}) {
    file.doc["images"][0]["uri"] = uri;
    EXPECT_EQ(load_gltf(folder.write("a.gltf", bytes_of(file.gltf()))).textures.at(0).rgba, kTwoByTwo) << uri;
  }
  file.doc["images"][0]["uri"] = "data:image/png;base64," + base64(picture);
  EXPECT_EQ(file.load().textures.at(0).rgba, kTwoByTwo);
  file.doc["images"][0]["uri"] = "my%20picture%20%C3%A9.png";
  EXPECT_TRUE(has_warning(file.load(), "only this one is read"));  // from memory
}

TEST(GltfMaterial, FilesOutsideTheFolderAreNotOpened) {
  const ScratchFolder outside("outside"), folder("inside");
  const auto secret = outside.write("secret.png", png_rgba(2, 2, kTwoByTwo));
  std::filesystem::create_symlink(secret, folder.path / "link.png");
  std::filesystem::create_directory_symlink(outside.path, folder.path / "linked");
  GltfFile file = textured_file();
  file.doc["images"][0].erase("bufferView");
  const std::string up = "../" + outside.path.filename().string() + "/secret.png";
  const std::string coded_up = "%2e%2e%2f" + outside.path.filename().string() + "%2fsecret.png";
  for (const std::string& uri : {secret.string(), "file://" + secret.string(), up, coded_up, std::string("link.png"),
                                 std::string("linked/secret.png"), std::string("."), std::string("x/../.."),
                                 std::string("a%00.png"), std::string("C:\\x.png"), std::string("..\\x.png"),
                                 std::string("http://x/y.png"), std::string("/dev/zero"), std::string("nothing.png")}) {
    file.doc["images"][0]["uri"] = uri;
    const Scene scene = load_gltf(folder.write("a.gltf", bytes_of(file.gltf())));
    EXPECT_TRUE(is_checker(scene.textures.at(0))) << uri;
    EXPECT_TRUE(has_warning(scene, "shown as a magenta checker")) << uri;
  }
}

TEST(GltfMaterial, BuffersOutsideAreRefusedToo) {
  const ScratchFolder folder("buffers");
  for (const char* uri : {".", "..", "../x.bin", "/dev/zero", "", "nothing.bin"}) {
    GltfFile file = triangle_file();
    file.doc["buffers"] = json::array({{{"byteLength", 36}, {"uri", uri}}});
    const auto path = folder.write("a.gltf", bytes_of(file.gltf()));
    try {
      load_gltf(path);
      ADD_FAILURE() << uri;
    } catch (const std::exception& error) {
      EXPECT_NE(std::string(error.what()).find("nothing drawable in it (buffers[0]: "), std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace gbl::test
