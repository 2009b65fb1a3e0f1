// The only file that sees tinygltf (slow to compile). The library reads the tidied text and nothing else: it opens no
// file, decodes no image and follows no index.
#include "renderer/gltf/gltf_document.h"

#include <cmath>
#include <fmt/format.h>
#include <fstream>  // the library's writer wants it
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_FS
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wshadow"
#include <tiny_gltf.h>
#pragma GCC diagnostic pop

namespace gbl::gltf {
namespace {

const tinygltf::Value* extension(const tinygltf::ExtensionMap& map, const char* name) {
  const auto found = map.find(name);
  return found == map.end() ? nullptr : &found->second;
}

double number(const tinygltf::Value& object, const char* member, double otherwise) {
  return object.Has(member) ? object.Get(member).GetNumberAsDouble() : otherwise;
}

// As many numbers as the vector has.
template <class Vector>
Vector numbers(const tinygltf::Value& object, const char* member, double otherwise) {
  Vector out(otherwise);
  const tinygltf::Value& list = object.Get(member);
  if (!object.Has(member) || list.ArrayLen() != size_t(Vector::length())) return out;
  for (int k = 0; k < Vector::length(); ++k) out[k] = list.Get(k).GetNumberAsDouble();
  return out;
}

Accessor accessor_of(const tinygltf::Accessor& from) {
  Accessor to{from.bufferView,
              from.byteOffset,
              from.count,
              from.componentType,
              tinygltf::GetNumComponentsInType(static_cast<uint32_t>(from.type)),
              from.normalized};
  if (!from.sparse.isSparse) return to;
  const auto& s = from.sparse;
  to.sparse = {static_cast<uint64_t>(s.count),
               s.indices.bufferView,
               s.values.bufferView,
               static_cast<uint64_t>(s.indices.byteOffset),
               static_cast<uint64_t>(s.values.byteOffset),
               s.indices.componentType};
  return to;
}

int attribute(const tinygltf::Primitive& primitive, const char* name) {
  const auto found = primitive.attributes.find(name);
  return found == primitive.attributes.end() ? -1 : found->second;
}

MeshSource mesh_of(const tinygltf::Mesh& from, size_t index) {
  MeshSource mesh{from.name.empty() ? fmt::format("mesh {}", index) : clean_name(from.name), {}};
  for (const tinygltf::Primitive& p : from.primitives)
    mesh.primitives.push_back({attribute(p, "POSITION"),
                               attribute(p, "NORMAL"),
                               attribute(p, "TANGENT"),
                               {attribute(p, "TEXCOORD_0"), attribute(p, "TEXCOORD_1")},
                               attribute(p, "COLOR_0"),
                               attribute(p, "JOINTS_0"),
                               attribute(p, "WEIGHTS_0"),
                               p.indices,
                               p.material,
                               p.mode});
  return mesh;
}

// Specification 3.5.3: a matrix, or translation * rotation * scale.
glm::dmat4 transform_of(const tinygltf::Node& node) {
  if (node.matrix.size() == 16) return glm::make_mat4(node.matrix.data());
  glm::dmat4 m(1);
  if (node.translation.size() == 3) m = glm::translate(m, glm::make_vec3(node.translation.data()));
  if (node.rotation.size() == 4) {
    const glm::dquat q(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
    if (const double length = glm::length(q); length > 0 && std::isfinite(length)) m *= glm::mat4_cast(q / length);
  }
  if (node.scale.size() == 3) m = glm::scale(m, glm::make_vec3(node.scale.data()));
  return m;
}

Node node_of(const tinygltf::Node& from, size_t index) {
  Node node{from.name.empty() ? fmt::format("node {}", index) : clean_name(from.name), from.mesh, from.skin,
            from.camera};
  if (const auto* light = extension(from.extensions, "KHR_lights_punctual"))
    node.light = light->Get("light").GetNumberAsInt();
  node.children = from.children;
  node.parent_from_node = transform_of(from);
  return node;
}

// KHR_texture_transform: T * R * S on column vectors (u, v, 1); counter-clockwise as a picture with v downwards is seen.
glm::mat3 uv_transform(const tinygltf::Value& t) {
  const glm::dvec2 offset = numbers<glm::dvec2>(t, "offset", 0), scale = numbers<glm::dvec2>(t, "scale", 1);
  const double angle = number(t, "rotation", 0), c = std::cos(angle), s = std::sin(angle);
  constexpr double kMost = 1e6;  // beyond it a float has no digits left for the place in the picture
  if (glm::any(glm::greaterThan(glm::abs(glm::dvec4(offset, scale)), glm::dvec4(kMost))) || !std::isfinite(c))
    return glm::mat3(1);
  return glm::mat3(glm::dmat3(c * scale.x, -s * scale.x, 0, s * scale.y, c * scale.y, 0, offset.x, offset.y, 1));
}

template <class TextureInfo>
TextureUse use_of(const TextureInfo& from, const std::string& material, Job& job) {
  TextureUse use{from.index, from.texCoord};
  if (const auto* transform = extension(from.extensions, "KHR_texture_transform")) {
    use.uv_transform = uv_transform(*transform);
    use.uv_set = static_cast<int>(number(*transform, "texCoord", use.uv_set));
  }
  if (use.uv_set > 1) {
    job.note(fmt::format("material '{}': texture coordinates {} are not read, 0 is used", material, use.uv_set));
    use.uv_set = 0;
  }
  return use;
}

// A texture that an extension names, as those of the core are named.
TextureUse use_of(const tinygltf::Value& extension, const char* member, const std::string& material, Job& job) {
  tinygltf::TextureInfo info;
  if (!extension.Has(member)) return {};
  const tinygltf::Value& use = extension.Get(member);
  info.index = static_cast<int>(number(use, "index", kNoTexture));
  info.texCoord = static_cast<int>(number(use, "texCoord", 0));
  if (use.Has("extensions"))
    for (const auto& [name, value] : use.Get("extensions").Get<tinygltf::Value::Object>())
      info.extensions[name] = value;
  return use_of(info, material, job);
}

AlphaMode alpha_mode(const std::string& word, const std::string& material, Job& job) {
  if (word == "MASK") return AlphaMode::mask;
  if (word == "BLEND") return AlphaMode::blend;
  if (word != "OPAQUE") job.note(fmt::format("material '{}': unknown alphaMode; opaque", material));
  return AlphaMode::opaque;
}

// Numbers from the file, kept where a float can work with them.
float within(double value, double least, double most) { return static_cast<float>(glm::clamp(value, least, most)); }
glm::vec3 within(const glm::dvec3& v, double least, double most) {
  return {within(v.x, least, most), within(v.y, least, most), within(v.z, least, most)};
}

// KHR_materials_ior allows 0, which reflects all, and 1 and more.
float refraction_index(double index) { return index == 0 ? 0 : within(index, 1, 1e3); }

void read_specular(const tinygltf::Value& from, Material& to, Job& job) {
  to.specular = within(number(from, "specularFactor", 1), 0, 1);
  to.specular_colour = within(numbers<glm::dvec3>(from, "specularColorFactor", 1), 0, 1e3);
  to.specular_texture = use_of(from, "specularTexture", to.name, job);
  to.specular_colour_texture = use_of(from, "specularColorTexture", to.name, job);
}

Material material_of(const tinygltf::Material& from, size_t index, Job& job) {
  Material to;
  const auto& pbr = from.pbrMetallicRoughness;
  to.name = from.name.empty() ? fmt::format("material {}", index) : clean_name(from.name);
  const double* base = pbr.baseColorFactor.data();
  to.base_colour = {within(glm::make_vec3(base), 0, 1), within(base[3], 0, 1)};
  to.metal = within(pbr.metallicFactor, 0, 1);
  to.roughness = within(pbr.roughnessFactor, 0, 1);
  to.emissive = within(glm::make_vec3(from.emissiveFactor.data()), 0, 1);
  if (const auto* strength = extension(from.extensions, "KHR_materials_emissive_strength"))
    to.emissive *= within(number(*strength, "emissiveStrength", 1), 0, 1e6);
  to.normal_scale = within(from.normalTexture.scale, -1e3, 1e3);
  to.occlusion_strength = within(from.occlusionTexture.strength, 0, 1);
  to.base_colour_texture = use_of(pbr.baseColorTexture, to.name, job);
  to.roughness_texture = use_of(pbr.metallicRoughnessTexture, to.name, job);
  to.normal_texture = use_of(from.normalTexture, to.name, job);
  to.occlusion_texture = use_of(from.occlusionTexture, to.name, job);
  to.emissive_texture = use_of(from.emissiveTexture, to.name, job);
  to.alpha_mode = alpha_mode(from.alphaMode, to.name, job);
  to.alpha_cutoff = within(from.alphaCutoff, 0, 1e3);
  to.double_sided = from.doubleSided;
  to.unlit = extension(from.extensions, "KHR_materials_unlit") != nullptr;
  if (const auto* ior = extension(from.extensions, "KHR_materials_ior"))
    to.refraction_index = refraction_index(number(*ior, "ior", 1.5));
  if (const auto* clear = extension(from.extensions, "KHR_materials_transmission")) {
    to.transmission = within(number(*clear, "transmissionFactor", 0), 0, 1);
    if (clear->Has("transmissionTexture"))
      job.note(fmt::format("material '{}': its transmission texture is not read; it is as clear everywhere", to.name));
  }
  if (const auto* specular = extension(from.extensions, "KHR_materials_specular")) read_specular(*specular, to, job);
  return to;
}

TextureSource texture_of(const tinygltf::Texture& from, const tinygltf::Model& model) {
  TextureSource to{from.source, {}};
  if (from.sampler < 0) return to;
  const tinygltf::Sampler& sampler = model.samplers[static_cast<size_t>(from.sampler)];
  to.sampler = sampler_of(sampler.wrapS, sampler.wrapT, sampler.minFilter, sampler.magFilter);
  return to;
}

// A camera's frame is what its author wants to be seen (specification 3.10.3); one of no sensible shape asks nothing.
double wholly_shown(double aspect) { return aspect > 0 && aspect <= 1000 ? aspect : 0; }

CameraSource camera_of(const tinygltf::Camera& from) {
  CameraSource to;
  if (from.type == "perspective") {
    const auto& p = from.perspective;
    to.endless = p.zfar == 0;
    to.camera.fov = glm::degrees(p.yfov);
    to.camera.aspect = wholly_shown(p.aspectRatio);
    to.camera.near = p.znear;
    to.camera.far = to.endless ? p.znear * kGltfFarOfEndlessCamera : p.zfar;
    to.usable = p.yfov > 0 && to.camera.fov < 179.9 && p.znear > 0;
  } else {
    const auto& o = from.orthographic;
    to.camera.orthographic_height = 2 * std::abs(o.ymag);
    to.camera.aspect = wholly_shown(std::abs(o.xmag / o.ymag));
    // The specification allows a near of 0; ours lies in front of the camera.
    to.camera.near = glm::max(o.znear, o.zfar * 1e-6);
    to.camera.far = o.zfar;
    to.usable = o.ymag != 0;
  }
  to.usable = to.usable && to.camera.near > 0 && to.camera.far > to.camera.near && to.camera.far < 1e18;
  return to;
}

// KHR_lights_punctual: candela for point and spot, lux for directional.
LightSource light_of(const tinygltf::Light& from) {
  LightSource to;
  Light& light = to.light;
  to.usable = from.type == "point" || from.type == "spot" || from.type == "directional";
  light.kind = from.type == "spot" ? LightKind::spot : from.type == "point" ? LightKind::point : LightKind::directional;
  light.colour = (from.color.size() == 3 ? glm::make_vec3(from.color.data()) : glm::dvec3(1)) * from.intensity;
  light.range = from.range > 0 && light.kind != LightKind::directional ? from.range : kEndless;
  light.ends_faint = light.range >= kEndless && light.kind != LightKind::directional;
  light.direction = {0, 0, -1};
  const double outer = glm::clamp(from.spot.outerConeAngle, 0.0, glm::radians(90.0));
  const double inner = glm::clamp(from.spot.innerConeAngle, 0.0, outer);
  if (light.kind == LightKind::spot) light.inner_cos = std::cos(inner), light.outer_cos = std::cos(outer);
  return to;
}

}  // namespace

Document read_document(TidyJson tidied, Job& job) {
  tinygltf::TinyGLTF library;
  tinygltf::Model model;
  std::string error, warning;
  bool read = false;
  try {
    read = library.LoadASCIIFromString(&model, &error, &warning, tidied.text.data(),
                                       static_cast<unsigned>(tidied.text.size()), "");
  } catch (const std::exception& e) {
    error = e.what();
  }
  if (!read) job.refuse(fmt::format("not readable: {}", clean_name(error)), "export the model again");
  std::string().swap(tidied.text);
  Document document;
  for (const auto& v : model.bufferViews)
    document.views.push_back({v.buffer, v.byteOffset, v.byteLength, v.byteStride});
  for (const auto& a : model.accessors) document.accessors.push_back(accessor_of(a));
  for (const auto& m : model.meshes) document.meshes.push_back(mesh_of(m, document.meshes.size()));
  for (const auto& n : model.nodes) document.nodes.push_back(node_of(n, document.nodes.size()));
  for (const auto& s : model.scenes) document.scenes.push_back(s.nodes);
  for (const auto& s : model.skins) document.skins.push_back({s.joints, s.inverseBindMatrices});
  for (const auto& m : model.materials) document.materials.push_back(material_of(m, document.materials.size(), job));
  for (const auto& t : model.textures) document.textures.push_back(texture_of(t, model));
  for (const auto& c : model.cameras) document.cameras.push_back(camera_of(c));
  for (const auto& l : model.lights) document.lights.push_back(light_of(l));
  document.scene = model.defaultScene >= 0 ? model.defaultScene : document.scenes.empty() ? -1 : 0;
  document.images = std::move(tidied.images);
  return document;
}

}  // namespace gbl::gltf
