#include "renderer/gltf/gltf_instances.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "renderer/gltf/gltf_limits.h"

namespace gbl::gltf {
namespace {

struct Built {
  int mesh = 0, material = 0;
};

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
    } catch (const Broken& broken) {
      job_.note(fmt::format("skins[{}]: {}; its meshes are shown as they lie", index, broken.what()));
      return {};
    }
    return matrices;
  }

  void build(const MeshSource& source, const JointMatrices& joints, std::vector<Built>& parts) {
    for (size_t i = 0; i < source.primitives.size(); ++i) {
      const Primitive& primitive = source.primitives[i];
      if (primitive.mode >= 0 && primitive.mode <= 3) {
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

Bounds empty_bounds() {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  return {glm::dvec3(kInf), glm::dvec3(-kInf)};
}

void include(Bounds& bounds, const glm::dvec3& p) {
  bounds.min = glm::min(bounds.min, p);
  bounds.max = glm::max(bounds.max, p);
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
      scene.instances.push_back(
          {node.name, part.mesh, part.material, posed ? glm::dmat4(1) : placed[i].world_from_node});
    }
    if (scene.instances.size() > kMaxInstances)
      job.refuse_limit("placed primitives", scene.instances.size(), kMaxInstances);
    if (drawn > kMaxDrawnTriangles) job.refuse_limit("triangles to draw", drawn, kMaxDrawnTriangles);
  }
}

void set_bounds(Scene& scene) {
  constexpr uint64_t kExactPoints = 20'000'000;
  uint64_t points = 0;
  std::vector<Bounds> boxes(scene.meshes.size(), empty_bounds());
  for (size_t m = 0; m < boxes.size(); ++m)
    for (const Vertex& v : scene.meshes[m].vertices) include(boxes[m], glm::dvec3(v.position));
  for (const Instance& instance : scene.instances)
    points += scene.meshes[static_cast<size_t>(instance.mesh)].vertices.size();
  if (points <= kExactPoints) {
    scene.bounds = bounds_of(scene);
    return;
  }
  scene.bounds = empty_bounds();
  for (const Instance& instance : scene.instances)
    for (int corner = 0; corner < 8; ++corner) {
      const Bounds& box = boxes[static_cast<size_t>(instance.mesh)];
      const glm::dvec3 p(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                         corner & 4 ? box.max.z : box.min.z);
      include(scene.bounds, glm::dvec3(instance.world_from_object * glm::dvec4(p, 1)));
    }
}

}  // namespace gbl::gltf
