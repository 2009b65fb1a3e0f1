#include <cmath>
#include <fmt/format.h>

#include "renderer/gltf/gltf_limits.h"
#include "renderer/gltf/gltf_primitive.h"
#include "renderer/gltf/tangents.h"

namespace gbl::gltf {
namespace {

bool finite(const glm::vec3& v) {
  return std::abs(v.x) < kMaxCoordinate && std::abs(v.y) < kMaxCoordinate && std::abs(v.z) < kMaxCoordinate;
}

// Absent attributes give empty Numbers; present ones must cover every vertex.
Numbers attribute(const Document& document, int accessor, const char* name, int least, int most, size_t count,
                  bool always_normalised = false) {
  if (accessor < 0) return {};
  Numbers numbers = read_numbers(document, accessor, name, least, most, always_normalised);
  if (numbers.count() != count)
    throw Broken(fmt::format("{} has {} elements for {} vertices", name, numbers.count(), count));
  return numbers;
}

void read_uv(const Document& document, int accessor, const char* name, glm::vec2 Vertex::*member, VertexData& data) {
  const Numbers uv = attribute(document, accessor, name, 2, 2, data.vertices.size());
  for (size_t i = 0; i < uv.count(); ++i)
    for (int c = 0; c < 2; ++c) (data.vertices[i].*member)[c] = std::isfinite(uv[i][c]) ? uv[i][c] : 0.f;
}

void read_colours(const Document& document, int accessor, VertexData& data) {
  const Numbers colour = attribute(document, accessor, "COLOR_0", 3, 4, data.vertices.size(), true);
  for (size_t i = 0; i < colour.count(); ++i)
    for (size_t c = 0; c < colour.components; ++c)
      data.vertices[i].colour[static_cast<int>(c)] = std::isfinite(colour[i][c]) ? colour[i][c] : 1.f;
}

// A direction without length stays zero here; what is zero gets a value when its triangles are known.
glm::vec3 unit(const glm::vec3& v) {
  const double length = glm::length(glm::dvec3(v));
  return length > 1e-12 && std::isfinite(length) ? glm::vec3(glm::dvec3(v) / length) : glm::vec3(0);
}

void read_directions(const Document& document, const Primitive& primitive, VertexData& data) {
  const Numbers normal = attribute(document, primitive.normal, "NORMAL", 3, 3, data.vertices.size());
  data.has_normals = normal.count() > 0;
  for (size_t i = 0; i < normal.count(); ++i)
    data.vertices[i].normal = unit({normal[i][0], normal[i][1], normal[i][2]});
  if (!data.has_normals) return;  // specification 3.7.2.1: then given tangents are to be ignored
  const Numbers tangent = attribute(document, primitive.tangent, "TANGENT", 4, 4, data.vertices.size());
  data.has_tangents = tangent.count() > 0;
  for (size_t i = 0; i < tangent.count(); ++i)
    data.vertices[i].tangent = {unit({tangent[i][0], tangent[i][1], tangent[i][2]}), tangent[i][3] < 0 ? -1 : 1};
}

// Normals follow the matrix of cofactors: the inverse transpose times the determinant, which needs no inverse.
glm::dmat3 cofactors(const glm::dmat3& m) {
  return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

// Specification 3.7.3.3: a vertex follows the weighted sum of its joints' matrices; weights should sum to 1.
void pose(const Document& document, const Primitive& primitive, const JointMatrices& joints, VertexData& data) {
  const size_t count = data.vertices.size();
  const Numbers joint = attribute(document, primitive.joints, "JOINTS_0", 4, 4, count);
  const Numbers weight = attribute(document, primitive.weights, "WEIGHTS_0", 4, 4, count, true);
  for (size_t i = 0; i < count; ++i) {
    glm::dmat4 blend(0);
    double total = 0;
    for (int k = 0; k < 4; ++k) {
      const double w = weight[i][k];
      if (!(w > 0) || !std::isfinite(w)) continue;
      if (!(joint[i][k] >= 0 && joint[i][k] < static_cast<float>(joints.size())))
        throw Broken(fmt::format("joint {} of {}", joint[i][k], joints.size()));
      blend += joints[static_cast<size_t>(joint[i][k])] * w;
      total += w;
    }
    if (!(total > 0)) continue;
    blend /= total;
    Vertex& v = data.vertices[i];
    const double turned = glm::determinant(glm::dmat3(blend)) < 0 ? -1 : 1;
    v.position = glm::vec3(glm::dvec3(blend * glm::dvec4(v.position, 1)));
    v.normal = unit(glm::vec3(glm::normalize(cofactors(glm::dmat3(blend)) * glm::dvec3(v.normal)) * turned));
    v.tangent = {unit(glm::vec3(glm::dmat3(blend) * glm::dvec3(v.tangent))), v.tangent.w};
  }
}

}  // namespace

VertexData read_vertices(const Document& document, const Primitive& primitive, const JointMatrices& joints,
                         const std::string& name, Job& job) {
  if (primitive.position < 0) throw Broken("'POSITION' is missing");
  VertexData data;
  const Numbers position = read_numbers(document, primitive.position, "POSITION", 3, 3);
  if (position.count() > kMaxVertices) throw Broken(fmt::format("{} vertices, too many", position.count()));
  data.vertices.resize(position.count(), Vertex{glm::vec3(0), glm::vec3(0), glm::vec4(0, 0, 0, 1), glm::vec2(0)});
  for (size_t i = 0; i < position.count(); ++i)
    data.vertices[i].position = {position[i][0], position[i][1], position[i][2]};
  read_directions(document, primitive, data);
  read_uv(document, primitive.uv[0], "TEXCOORD_0", &Vertex::uv, data);
  read_uv(document, primitive.uv[1], "TEXCOORD_1", &Vertex::uv1, data);
  read_colours(document, primitive.colour, data);
  if (!joints.empty()) {
    if (primitive.joints >= 0 && primitive.weights >= 0)
      pose(document, primitive, joints, data);
    else
      job.note(fmt::format("mesh '{}': skinned, but without joints and weights; shown as it lies", name));
  }
  data.unusable.resize(data.vertices.size());
  for (size_t i = 0; i < data.vertices.size(); ++i)
    if (!finite(data.vertices[i].position)) {
      data.unusable[i] = true;
      data.vertices[i].position = glm::vec3(0);  // it may stay in the buffer, and in nobody's bounds
    }
  return data;
}

}  // namespace gbl::gltf
