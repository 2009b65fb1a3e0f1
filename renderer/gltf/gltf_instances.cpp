#include "renderer/gltf/gltf_instances.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <span>

#include "renderer/gltf/gltf_limits.h"

namespace gbl::gltf {
namespace {

struct Built {
  int mesh = 0, material = 0;
  glm::dvec3 origin{0};  // in the mesh's own space: where the origin of its vertices has been moved
};

bool is_points_or_lines(const Primitive& primitive) { return primitive.mode >= 0 && primitive.mode <= 3; }

// Vertices far from their own origin lose digits as soon as they are turned: at 1e6, 6 cm. Along each axis on which
// they stand farther off than they are wide, they are moved to the origin; there the subtraction of floats is exact
// (Sterbenz 1974, "Floating-Point Computation"), and instances move them back in double.
glm::dvec3 move_to_origin(std::span<Mesh> parts) {
  glm::vec3 low(INFINITY), high(-INFINITY);
  for (const Mesh& mesh : parts)
    for (const Vertex& v : mesh.vertices) low = glm::min(low, v.position), high = glm::max(high, v.position);
  glm::vec3 origin(0);
  for (int axis = 0; axis < 3; ++axis) {
    const float middle = low[axis] / 2 + high[axis] / 2;
    if (std::abs(middle) > high[axis] - low[axis]) origin[axis] = middle;
  }
  if (origin == glm::vec3(0)) return glm::dvec3(0);
  for (Mesh& mesh : parts)
    for (Vertex& v : mesh.vertices) v.position -= origin;
  return glm::dvec3(origin);
}

class Builder {
 public:
  Builder(const Document& document, const std::vector<PlacedNode>& placed, Materials& materials, Scene& scene, Job& job)
      : document_(document), materials_(materials), scene_(scene), job_(job) {
    place_of_node_.resize(document.nodes.size(), nullptr);
    for (const PlacedNode& p : placed) place_of_node_[static_cast<size_t>(p.node)] = &p;
  }

  // The parts of a mesh, built when it is first asked for.
  const std::vector<Built>& parts(int mesh, int skin) {
    const auto [entry, is_new] = built_.try_emplace({mesh, skin});
    if (is_new) build(document_.meshes[static_cast<size_t>(mesh)], joint_matrices(skin), entry->second);
    return entry->second;
  }

 private:
  // Specification 3.7.3.1: world from joint * inverse bind matrix; the node's own transform does not count.
  JointMatrices joint_matrices(int index) {
    if (index < 0) return {};
    const Skin& skin = document_.skins[static_cast<size_t>(index)];
    JointMatrices matrices(skin.joints.size(), glm::dmat4(1));
    try {
      Numbers bind;
      if (skin.inverse_bind >= 0) bind = read_numbers(document_, skin.inverse_bind, "inverseBindMatrices", 16, 16);
      if (skin.inverse_bind >= 0 && bind.count() < matrices.size())
        throw Broken(fmt::format("{} bind matrices for {} joints", bind.count(), matrices.size()));
      for (size_t j = 0; j < matrices.size(); ++j) {
        const PlacedNode* joint = place_of_node_[static_cast<size_t>(skin.joints[j])];
        if (!joint) throw Broken("a joint is not in the scene");
        for (int e = 0; skin.inverse_bind >= 0 && e < 16; ++e) matrices[j][e / 4][e % 4] = bind[j][e];
        matrices[j] = joint->world_from_node * matrices[j];
      }
      job_.note("skinned meshes are shown in their rest pose");
    } catch (const Broken& broken) {
      job_.note(fmt::format("skins[{}]: {}; its meshes are shown as they lie", index, broken.what()));
      return {};
    }
    return matrices;
  }

  void build(const MeshSource& source, const JointMatrices& joints, std::vector<Built>& parts) {
    const size_t first = scene_.meshes.size();
    for (size_t i = 0; i < source.primitives.size(); ++i) {
      const Primitive& primitive = source.primitives[i];
      if (is_points_or_lines(primitive)) {
        job_.note("points and lines are not drawn");
        continue;
      }
      if (primitive.mode < 0) continue;  // said when it was set aside
      try {
        const std::string name = source.primitives.size() > 1 ? fmt::format("{}.{}", source.name, i) : source.name;
        Mesh mesh = build_mesh(document_, primitive, joints, materials_.tangent_need(primitive.material), name, job_);
        if (mesh.indices.empty()) continue;
        count(mesh);
        parts.push_back({static_cast<int>(scene_.meshes.size()), materials_.use(primitive.material)});
        scene_.meshes.push_back(std::move(mesh));
      } catch (const Broken& broken) {
        job_.note(fmt::format("mesh '{}', primitive {}: {}; not drawn", source.name, i, broken.what()));
      }
    }
    const glm::dvec3 origin = move_to_origin(std::span(scene_.meshes).subspan(first));
    for (Built& part : parts) part.origin = origin;
  }

  void count(const Mesh& mesh) {
    vertices_ += mesh.vertices.size();
    triangles_ += mesh.indices.size() / 3;
    if (vertices_ > kMaxVertices) job_.refuse_limit("vertices", vertices_, kMaxVertices);
    if (triangles_ > kMaxTriangles) job_.refuse_limit("triangles", triangles_, kMaxTriangles);
  }

  const Document& document_;
  Materials& materials_;
  Scene& scene_;
  Job& job_;
  std::vector<const PlacedNode*> place_of_node_;
  std::map<std::pair<int, int>, std::vector<Built>> built_;
  uint64_t vertices_ = 0, triangles_ = 0;
};

// A scale of 0 hides a node (specification 3.5.3); such a matrix has no inverse for the normals.
bool flattens(const glm::dmat4& m) {
  const double volume = std::abs(glm::determinant(glm::dmat3(m)));
  const double edges = glm::length(glm::dvec3(m[0])) * glm::length(glm::dvec3(m[1])) * glm::length(glm::dvec3(m[2]));
  return !(volume > 1e-12 * edges);
}

}  // namespace

void add_instances(const Document& document, const std::vector<PlacedNode>& placed, Materials& materials, Scene& scene,
                   Job& job) {
  Builder builder(document, placed, materials, scene, job);
  uint64_t drawn = 0;
  for (size_t i = 0; i < placed.size(); ++i) {
    if (i % 64 == 0) job.step("meshes", 0.2 + 0.4 * static_cast<double>(i) / static_cast<double>(placed.size()));
    const Node& node = document.nodes[static_cast<size_t>(placed[i].node)];
    if (node.mesh < 0) continue;
    const bool posed = node.skin >= 0 && !document.skins[static_cast<size_t>(node.skin)].joints.empty();
    if (!posed && flattens(placed[i].world_from_node)) {
      job.note(fmt::format("node '{}': flattened by a scale of 0; not drawn", node.name));
      continue;
    }
    for (const Built& part : builder.parts(node.mesh, posed ? node.skin : -1)) {
      drawn += scene.meshes[static_cast<size_t>(part.mesh)].indices.size() / 3;
      const glm::dmat4 world_from_mesh = posed ? glm::dmat4(1) : placed[i].world_from_node;
      scene.instances.push_back({node.name, part.mesh, part.material, glm::translate(world_from_mesh, part.origin)});
    }
    if (scene.instances.size() > kMaxInstances)
      job.refuse_limit("placed primitives", scene.instances.size(), kMaxInstances);
    if (drawn > kMaxDrawnTriangles) job.refuse_limit("triangles to draw", drawn, kMaxDrawnTriangles);
  }
}

bool has_points_or_lines(const Document& document, const std::vector<PlacedNode>& placed) {
  return std::any_of(placed.begin(), placed.end(), [&](const PlacedNode& p) {
    const int mesh = document.nodes[static_cast<size_t>(p.node)].mesh;
    if (mesh < 0) return false;
    const auto& primitives = document.meshes[static_cast<size_t>(mesh)].primitives;
    return std::any_of(primitives.begin(), primitives.end(), is_points_or_lines);
  });
}

}  // namespace gbl::gltf
