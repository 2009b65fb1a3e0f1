#include "renderer/reflection/mirrors.h"

#include <cmath>
#include <optional>

#include "renderer/light/shadow_maps.h"

namespace gbl {
namespace {

constexpr double kFlat = 1e-6;  // a corner's distance to the plane, of the mesh's extent; and 1 - cosine of a normal

// The plane that holds all of a mesh, where each corner's normal is the plane's.
std::optional<Plane> plane_of(const Mesh& mesh) {
  if (mesh.vertices.empty()) return {};
  const glm::dvec3 normal = glm::normalize(glm::dvec3(mesh.vertices[0].normal)), at(mesh.vertices[0].position);
  double extent = 0, off = 0;
  for (const Vertex& v : mesh.vertices) {
    if (!(glm::dot(glm::normalize(glm::dvec3(v.normal)), normal) > 1 - kFlat)) return {};
    extent = std::max(extent, glm::distance(glm::dvec3(v.position), at));
    off = std::max(off, std::abs(glm::dot(glm::dvec3(v.position) - at, normal)));
  }
  if (!(off <= kFlat * extent)) return {};
  return Plane{normal, glm::dot(normal, at)};
}

Plane moved(const Plane& p, const glm::dmat4& world_from_object) {
  const glm::dmat3 normals = glm::transpose(glm::inverse(glm::dmat3(world_from_object)));
  const glm::dvec3 normal = glm::normalize(normals * p.normal);
  const glm::dvec3 at = world_from_object * glm::dvec4(p.normal * p.offset, 1);
  return {normal, glm::dot(normal, at)};
}

void take_box(Mirror& m, const Mesh& mesh, const glm::dmat4& world_from_object) {
  glm::dvec3 low(INFINITY), high(-INFINITY);
  for (const Vertex& v : mesh.vertices) {
    const glm::dvec3 p = world_from_object * glm::dvec4(v.position, 1);
    low = glm::min(low, p), high = glm::max(high, p);
  }
  const glm::dvec3 half = (high - low) / 2.0;
  m.centre = (low + high) / 2.0;
  m.radius = std::min({half.x, half.y, half.z});
}

}  // namespace

static bool smooth(const Material& m) {
  return !m.unlit && m.roughness <= kMirrorRoughness && m.roughness_texture.texture == kNoTexture;
}

bool refracts(const Material& m) { return smooth(m) && m.transmission > 0 && m.alpha_mode != AlphaMode::mask; }

bool is_mirror(const Material& m) { return (smooth(m) && m.alpha_mode == AlphaMode::opaque) || refracts(m); }

bool blends(const Material& m, bool refraction) {
  return m.alpha_mode == AlphaMode::blend && !(refraction && refracts(m));
}

// Parallel rays see one side of a plane wherever the camera stands.
bool faces(const Plane& p, const Camera& c) {
  return c.orthographic() ? glm::dot(c.forward(), p.normal) < 0 : p.distance(c.position) > 0;
}

Plane facing(const Plane& p, const Camera& c) { return faces(p, c) ? p : Plane{-p.normal, -p.offset}; }

std::vector<Mirror> mirrors_of(const Scene& scene) {
  std::vector<Mirror> out;
  for (size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& in = scene.instances[i];
    const Mesh& mesh = scene.meshes[static_cast<size_t>(in.mesh)];
    const Material& material = scene.materials[static_cast<size_t>(in.material)];
    if (!is_mirror(material) || mesh.indices.empty() || glm::determinant(glm::dmat3(in.world_from_object)) == 0)
      continue;
    Mirror m{.object = static_cast<int>(i) + 1, .clear = refracts(material), .two_sided = material.double_sided};
    take_box(m, mesh, in.world_from_object);
    const std::optional<Plane> plane = plane_of(mesh);
    m.flat = plane && material.normal_texture.texture == kNoTexture && !m.clear;
    if (m.flat) m.plane = moved(*plane, in.world_from_object);
    out.push_back(m);
  }
  return out;
}

// A reflection turns a right-handed view into a left-handed one. The third axis turned round makes it right-handed again,
// and the picture's columns run the other way.
Camera mirrored(const Camera& c, const Plane& p) {
  const auto reflected = [&](const glm::dvec3& v) { return v - 2 * glm::dot(v, p.normal) * p.normal; };
  const glm::dvec3 forward = reflected(c.forward()), up = reflected(c.up());
  Camera out = c;
  out.position = c.position - 2 * p.distance(c.position) * p.normal;
  out.orientation = glm::normalize(glm::quat_cast(glm::dmat3(glm::cross(forward, up), up, -forward)));
  return out;
}

double side_tangent(int texels) { return texels / (texels - 2.0); }

Camera side_camera(const Mirror& m, int side, int texels, const Camera& like) {
  Camera out;
  out.position = m.centre;
  out.orientation = glm::normalize(glm::quat_cast(glm::transpose(view_of_cube_face(side))));
  out.fov = 2 * glm::degrees(std::atan(side_tangent(texels)));
  // What stands close to a small object is nearer than the view's near plane.
  out.near = m.radius > 0 ? std::min(like.near, 0.5 * m.radius) : like.near;
  out.far = like.far;
  return out;
}

}  // namespace gbl
