#include "renderer/passes/gpu_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "renderer/picture/srgb.h"

namespace gbl {

namespace {

constexpr GLuint kUv1 = 4, kColour = 5;  // what a mesh may do without
constexpr gl::VertexAttribute kAttributes[] = {
    {0, 3, offsetof(Vertex, position)}, {1, 3, offsetof(Vertex, normal)}, {2, 4, offsetof(Vertex, tangent)},
    {3, 2, offsetof(Vertex, uv)},       {kUv1, 2, offsetof(Vertex, uv1)}, {kColour, 4, offsetof(Vertex, colour)}};

const Vertex kPlain{};

// In bytes as they are uploaded, without what no vertex differs in from a plain one.
struct StoredVertices {
  std::vector<gl::VertexAttribute> attributes;
  size_t stride = 0;
  std::vector<std::byte> bytes;
};

StoredVertices stored(const Mesh& mesh, const std::vector<uint32_t>& order) {
  const auto any = [&](auto Vertex::*member) {
    return std::any_of(mesh.vertices.begin(), mesh.vertices.end(),
                       [&](const Vertex& v) { return v.*member != kPlain.*member; });
  };
  StoredVertices out;
  std::vector<size_t> from;
  for (const gl::VertexAttribute& a : kAttributes) {
    if ((a.location == kUv1 && !any(&Vertex::uv1)) || (a.location == kColour && !any(&Vertex::colour))) continue;
    out.attributes.push_back({a.location, a.components, out.stride});
    from.push_back(a.offset);
    out.stride += a.bytes();
  }
  out.bytes.resize(order.size() * out.stride);
  std::byte* to = out.bytes.data();
  for (const uint32_t i : order) {
    const auto* vertex = reinterpret_cast<const std::byte*>(&mesh.vertices[i]);
    for (size_t k = 0; k < from.size(); ++k)
      std::copy_n(vertex + from[k], out.attributes[k].bytes(), to + out.attributes[k].offset);
    to += out.stride;
  }
  return out;
}

GpuScene::GpuMesh upload(const Mesh& mesh) {
  MeshInParts ordered = in_parts(mesh);
  const StoredVertices vertices = stored(mesh, ordered.vertices);
  GpuScene::GpuMesh m;
  m.vertices = gl::make_buffer(GL_ARRAY_BUFFER, vertices.bytes.data(), vertices.bytes.size(), mesh.name);
  m.indices = gl::make_buffer(GL_ELEMENT_ARRAY_BUFFER, ordered.indices.data(), ordered.indices.size() * 4, mesh.name);
  m.vertex_array = gl::make_vertex_array(m.vertices, vertices.stride, vertices.attributes, &m.indices);
  m.index_count = static_cast<GLsizei>(mesh.indices.size());
  m.parts = std::move(ordered.parts);
  return m;
}

GpuScene::GpuMesh upload_unshared(const Mesh& mesh, size_t first, size_t end) {
  std::vector<Vertex> corners;
  corners.reserve(end - first);
  for (size_t i = first; i < end; ++i) corners.push_back(mesh.vertices[mesh.indices[i]]);
  GpuScene::GpuMesh m;
  m.vertices = gl::make_buffer(GL_ARRAY_BUFFER, corners.data(), corners.size() * sizeof(Vertex), mesh.name);
  m.vertex_array = vertex_array_of(m.vertices, nullptr);
  m.index_count = static_cast<GLsizei>(corners.size());
  return m;
}

gl::ImageDesc described(const Texture& t, bool srgb) {
  const auto address = [](Wrap w) { return static_cast<gl::Address>(w); };
  const auto filtering = [](Filter f) { return static_cast<gl::Filtering>(f); };
  return {.size = t.size,
          .rgba = t.rgba.data(),
          .srgb = srgb,
          .address_u = address(t.sampler.wrap_u),
          .address_v = address(t.sampler.wrap_v),
          .min = filtering(t.sampler.min),
          .mag = filtering(t.sampler.mag),
          .label = t.name};
}
static_assert(static_cast<int>(Wrap::mirror) == static_cast<int>(gl::Address::mirror));
static_assert(static_cast<int>(Filter::linear_mipmap_linear) == static_cast<int>(gl::Filtering::linear_mipmap_linear));

// No format holds sRGB codes of 16 bits: they are decoded here, and 16 linear bits keep more than 8 coded ones.
std::vector<uint16_t> linear_words(const std::vector<uint16_t>& coded) {
  std::vector<uint16_t> out(coded.size());
  for (size_t i = 0; i < coded.size(); ++i)
    out[i] =
        i % 4 == 3 ? coded[i] : static_cast<uint16_t>(std::lround(65535 * linear_from_srgb(double(coded[i]) / 65535)));
  return out;
}

gl::Texture upload(const Texture& t, bool srgb) {
  gl::ImageDesc d = described(t, srgb && t.rgba16.empty());
  if (t.rgba16.empty()) return gl::make_image(d);
  const std::vector<uint16_t> linear = srgb ? linear_words(t.rgba16) : std::vector<uint16_t>();
  d.rgba16 = srgb ? linear.data() : t.rgba16.data();
  return gl::make_image(d);
}

std::vector<GpuScene::Batch> batched(const Scene& scene) {
  std::map<std::tuple<int, int, bool>, GpuScene::Batch> by_key;
  for (size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const bool mirrored = glm::determinant(glm::dmat3(instance.world_from_object)) < 0;
    GpuScene::Batch& b = by_key[{instance.mesh, instance.material, mirrored}];
    b.mesh = instance.mesh, b.material = instance.material, b.mirrored = mirrored;
    b.instances.push_back(static_cast<int>(i));
  }
  std::vector<GpuScene::Batch> out;
  for (auto& [key, batch] : by_key) out.push_back(std::move(batch));
  return out;
}

}  // namespace

gl::VertexArray vertex_array_of(const gl::Buffer& vertices, const gl::Buffer* indices) {
  return gl::make_vertex_array(vertices, sizeof(Vertex), kAttributes, indices);
}

void GpuScene::GpuMesh::bind() const {
  glVertexAttrib2fv(kUv1, &kPlain.uv1.x);
  glVertexAttrib4fv(kColour, &kPlain.colour.x);
  glBindVertexArray(vertex_array.id());
}

static Bounds bounds_of_batch(const Scene& scene, const GpuScene::Batch& batch) {
  Bounds out = kNoBounds;
  const std::array<glm::dvec3, 8> corners = corners_of(bounds_of(scene.meshes[static_cast<size_t>(batch.mesh)]));
  for (const int i : batch.instances)
    for (const glm::dvec3& c : corners)
      include(out, scene.instances[static_cast<size_t>(i)].world_from_object * glm::dvec4(c, 1));
  const double below = double(scene.materials[static_cast<size_t>(batch.material)].height_depth);
  return {out.min - below, out.max + below};
}

GpuScene::GpuScene(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {
  for (const Mesh& m : scene_->meshes) meshes_.push_back(upload(m)), mesh_bounds_.push_back(bounds_of(m));
  batches_ = batched(*scene_);
  for (const Batch& b : batches_) batch_bounds_.push_back(bounds_of_batch(*scene_, b));
  const uint8_t white[] = {255, 255, 255, 255}, flat[] = {128, 128, 255, 255};
  white_ = gl::make_image({.rgba = white, .label = "white"});
  flat_normal_ = gl::make_image({.rgba = flat, .label = "flat normal"});
  srgb_.resize(scene_->textures.size());
  linear_.resize(scene_->textures.size());
}

GpuScene::GpuMesh GpuScene::unshared_part(int i, size_t first_triangle) const {
  const Mesh& mesh = scene_->meshes[static_cast<size_t>(i)];
  return upload_unshared(mesh, 3 * first_triangle, std::min(mesh.indices.size(), 3 * (first_triangle + kPart)));
}

const gl::Texture& GpuScene::uploaded(std::vector<gl::Texture>& set, int i, bool srgb) const {
  const Texture& t = scene_->textures[i];
  if (!set[i].name) set[i] = upload(t, srgb);
  return set[i];
}

const gl::Texture& GpuScene::colour_texture(int i, Colour colour) const {
  if (i == kNoTexture) return white_;
  return colour == Colour::srgb ? uploaded(srgb_, i, true) : uploaded(linear_, i, false);
}

const gl::Texture& GpuScene::data_texture(int i) const {
  return i == kNoTexture ? white_ : uploaded(linear_, i, false);
}

const gl::Texture& GpuScene::normal_texture(int i) const {
  return i == kNoTexture ? flat_normal_ : uploaded(linear_, i, false);
}

}  // namespace gbl
