#include "renderer/truth/ray_scene.h"

#include <limits>

#include "renderer/truth/ray_triangle.h"
#include "renderer/truth/texture_at.h"

namespace gbl {
namespace {

glm::dvec3 corner(const Mesh& mesh, size_t i) { return glm::dvec3(mesh.vertices[mesh.indices[i]].position); }

Bvh tree_of(const Mesh& mesh) {
  std::vector<Bounds> boxes;
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const glm::dvec3 a = corner(mesh, i), b = corner(mesh, i + 1), c = corner(mesh, i + 2);
    boxes.push_back({glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))});
  }
  return Bvh(boxes);
}

// The box about a box that is moved.
Bounds moved(const Bounds& b, const glm::dmat4& to) {
  Bounds out = kNoBounds;
  for (const glm::dvec3& c : corners_of(b)) include(out, to * glm::dvec4(c, 1));
  return out;
}

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

}  // namespace

RayScene::RayScene(const Scene& scene) : scene_(scene) {
  for (const Mesh& m : scene.meshes) meshes_.push_back(tree_of(m));
  for (size_t i = 0; i < scene.instances.size(); ++i)
    if (scene.materials[static_cast<size_t>(scene.instances[i].material)].alpha_mode != AlphaMode::blend) place(i);
  instances_ = Bvh(boxes_);
}

RayScene::RayScene(const Scene& scene, int object) : scene_(scene), meshes_(scene.meshes.size()) {
  const auto mesh = static_cast<size_t>(scene.instances[static_cast<size_t>(object - 1)].mesh);
  meshes_[mesh] = tree_of(scene.meshes[mesh]);
  place(static_cast<size_t>(object - 1));
  instances_ = Bvh(boxes_);
}

void RayScene::place(size_t instance) {
  const Instance& in = scene_.instances[instance];
  const Mesh& mesh = scene_.meshes[static_cast<size_t>(in.mesh)];
  const double volume = glm::determinant(glm::dmat3(in.world_from_object));
  // Flat: no side of it has an area, and nothing leads back to the object.
  if (mesh.indices.size() < 3 || volume == 0) return;
  const Bvh& triangles = meshes_[static_cast<size_t>(in.mesh)];
  placed_.push_back({&mesh, &triangles, &scene_.materials[static_cast<size_t>(in.material)],
                     glm::inverse(in.world_from_object), volume < 0, static_cast<int>(instance) + 1});
  boxes_.push_back(moved(triangles.bounds(), in.world_from_object));
  largest_coordinate_ = std::max({largest_coordinate_, largest(boxes_.back().min), largest(boxes_.back().max)});
}

template <class Use>
bool RayScene::along(const RayPart& ray, Use use) const {
  return instances_.along(ray, [&](uint32_t index, RayPart& world) {
    const Placed& p = placed_[index];
    // Not normalised: distances stay those of the world.
    const RayPart object{p.object_from_world * glm::dvec4(world.origin, 1),
                         p.object_from_world * glm::dvec4(world.direction, 0), world.from, world.to};
    return p.triangles->along(object, [&](uint32_t triangle, RayPart& part) {
      const size_t i = 3 * static_cast<size_t>(triangle);
      const auto hit =
          meet(part.origin, part.direction, corner(*p.mesh, i), corner(*p.mesh, i + 1), corner(*p.mesh, i + 2));
      if (!hit || !(hit->distance > part.from && hit->distance < part.to)) return false;
      if (in_hole(scene_, *p.mesh, &p.mesh->indices[i], *p.material, hit->weights)) return false;
      const bool done = use(
          SurfaceHit{
              {p.object, static_cast<int>(triangle)}, hit->distance, hit->weights, hit->from_behind != p.mirrored},
          part);
      world.to = part.to;
      return done;
    });
  });
}

std::optional<SurfaceHit> RayScene::first_hit(const RayPart& ray) const {
  std::optional<SurfaceHit> first;
  along(ray, [&](const SurfaceHit& hit, RayPart& part) {
    first = hit, part.to = hit.distance;
    return false;
  });
  return first;
}

bool RayScene::blocked(const RayPart& ray, const SeenSurface& except, bool from_below) const {
  return along(ray, [&](const SurfaceHit& hit, RayPart&) {
    const bool way_out = from_below && hit.from_behind && hit.surface.object == except.object;
    return hit.surface != except && !way_out;
  });
}

double RayScene::least_distance(const glm::dvec3& place) const {
  constexpr double kRoundings = 256;  // of placing the corners, of the crossing, of the way back into the object
  return kRoundings * std::numeric_limits<double>::epsilon() * std::max(largest_coordinate_, largest(place));
}

}  // namespace gbl
