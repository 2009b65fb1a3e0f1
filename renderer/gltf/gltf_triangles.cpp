#include <fmt/format.h>

#include "renderer/gltf/gltf_limits.h"
#include "renderer/gltf/gltf_primitive.h"

namespace gbl::gltf {
namespace {

constexpr int kTriangles = 4, kStrip = 5, kFan = 6;

// Specification 3.7.2.1, the winding of each kind.
std::vector<uint32_t> unrolled(const std::vector<uint32_t>& in, int mode) {
  std::vector<uint32_t> out;
  out.reserve(3 * (in.size() - 2));
  for (size_t i = 0; i + 2 < in.size(); ++i) {
    if (mode == kStrip) {
      const size_t odd = i % 2;
      out.insert(out.end(), {in[i], in[i + 1 + odd], in[i + 2 - odd]});
    } else {
      out.insert(out.end(), {in[i + 1], in[i + 2], in[0]});
    }
  }
  return out;
}

}  // namespace

std::vector<uint32_t> read_triangles(const Document& document, const Primitive& primitive, size_t vertex_count) {
  std::vector<uint32_t> indices;
  if (primitive.indices >= 0) {
    indices = read_indices(document, primitive.indices);
  } else {
    indices.resize(vertex_count);
    for (size_t i = 0; i < vertex_count; ++i) indices[i] = static_cast<uint32_t>(i);
  }
  for (const uint32_t index : indices)
    if (index >= vertex_count) throw Broken(fmt::format("index {} of {} vertices", index, vertex_count));
  if (indices.size() < 3) throw Broken("fewer than 3 vertices");
  const bool one_each = primitive.mode == kStrip || primitive.mode == kFan;  // triangles per index
  if (indices.size() > (one_each ? 1 : 3) * kMaxTriangles)
    throw Broken(fmt::format("{} indices, too many", indices.size()));
  if (one_each) return unrolled(indices, primitive.mode);
  if (primitive.mode != kTriangles) throw Broken(fmt::format("mode {} is not known", primitive.mode));
  indices.resize(indices.size() / 3 * 3);
  return indices;
}

}  // namespace gbl::gltf
