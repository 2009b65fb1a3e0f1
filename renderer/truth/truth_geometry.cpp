#include "renderer/truth/truth_geometry.h"

#include <algorithm>
#include <cmath>

#include "renderer/picture/srgb.h"
#include "renderer/reflection/mirrors.h"
#include "renderer/truth/height_fields.h"

namespace gbl {
namespace {

// colour=as-tutorial: codes are used as if linear.
glm::dvec3 colour_factor(const glm::dvec3& linear, Colour colour) {
  if (colour == Colour::srgb) return linear;
  return {srgb_from_linear(linear.x), srgb_from_linear(linear.y), srgb_from_linear(linear.z)};
}

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 1e-15 ? v / length : glm::dvec3(0);
}

template <class Member>
auto mixed(const Vertex* const (&corners)[3], const glm::dvec3& weights, Member member) {
  return weights.x * member(*corners[0]) + weights.y * member(*corners[1]) + weights.z * member(*corners[2]);
}

// The nearest point of an edge to p, as a parameter 0..1.
double along(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& p) {
  const glm::dvec3 edge = to - from;
  const double length2 = glm::dot(edge, edge);
  return length2 > 0 ? std::clamp(glm::dot(p - from, edge) / length2, 0.0, 1.0) : 0;
}

glm::dvec3 nearest_on_border(const glm::dvec3& p, const glm::dvec3 (&c)[3]) {
  glm::dvec3 best(1, 0, 0);
  double best2 = INFINITY;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const double t = along(c[i], c[j], p);
    const glm::dvec3 off = glm::mix(c[i], c[j], t) - p;
    if (glm::dot(off, off) >= best2) continue;
    best2 = glm::dot(off, off);
    best = glm::dvec3(0);
    best[i] = 1 - t, best[j] = t;
  }
  return best;
}

}  // namespace

Ray pixel_ray(const Camera& c, glm::ivec2 size, glm::ivec2 pixel) {
  const ViewRays rays = view_rays(c, double(size.x) / size.y);
  const double x = (pixel.x + 0.5) / size.x * 2 - 1, y = 1 - (pixel.y + 0.5) / size.y * 2;
  const glm::dvec3 sideways = x * rays.right + y * rays.up;
  if (c.orthographic()) return {sideways, rays.forward};
  return {glm::dvec3(0), rays.forward + sideways};
}

// Moeller and Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection".
glm::dvec3 barycentrics(const Ray& ray, const glm::dvec3 (&c)[3]) {
  const glm::dvec3 e1 = c[1] - c[0], e2 = c[2] - c[0], from = ray.origin - c[0];
  const glm::dvec3 p = glm::cross(ray.direction, e2), q = glm::cross(from, e1);
  const double determinant = glm::dot(e1, p);
  const double u = glm::dot(from, p) / determinant, v = glm::dot(ray.direction, q) / determinant;
  const glm::dvec3 weights(1 - u - v, u, v);
  if (weights.x >= 0 && weights.y >= 0 && weights.z >= 0) return weights;
  const glm::dvec3 met = ray.origin + glm::dot(e2, q) / determinant * ray.direction;
  // Seen edge on, the plane may be met anywhere: then any point of the triangle is as good.
  const bool finite = std::isfinite(met.x + met.y + met.z);
  return nearest_on_border(finite ? met : c[0], c);
}

TruthGeometry::TruthGeometry(const Settings& s, const Scene& scene, StoreFn store)
    : settings_(s),
      scene_(scene),
      model_(s),
      store_(std::move(store)),
      heights_(std::make_shared<HeightFields>(s, scene)) {
  for (const Instance& i : scene.instances) {
    Placed p{i.world_from_object};
    p.relative_from_object[3] -= glm::dvec4(s.camera.position, 0);
    const glm::dmat3 directions(i.world_from_object);
    p.normals = glm::transpose(glm::inverse(directions));
    p.mirrored = glm::determinant(directions) < 0;
    placed_.push_back(p);
  }
}

glm::dvec3 TruthGeometry::shading_normal(const Placed& placed, const Material& material,
                                         const Vertex* const (&corners)[3], const glm::dvec3& weights, bool front,
                                         const glm::vec4& texel) const {
  const double side = front ? 1 : -1;
  const glm::dvec3 n =
      glm::normalize(placed.normals * mixed(corners, weights, [](const Vertex& v) { return glm::dvec3(v.normal); })) *
      side;
  if (settings_.normal_map == NormalMap::off || material.normal_texture.texture == kNoTexture) return n;
  const glm::dmat3 directions(placed.relative_from_object);
  const auto tangent = [&](const Vertex& v) { return directions * glm::dvec3(v.tangent); };
  const auto bitangent = [&](const Vertex& v) {
    const double handed = v.tangent.w * (placed.mirrored ? -1.0 : 1.0);
    return handed * glm::cross(placed.normals * glm::dvec3(v.normal), directions * glm::dvec3(v.tangent));
  };
  const glm::dvec3 t = unit_or_zero(mixed(corners, weights, tangent)) * side;
  const glm::dvec3 b = unit_or_zero(mixed(corners, weights, bitangent)) * side;
  if (t == glm::dvec3(0)) return n;  // a mesh without tangents: the map cannot be turned
  const glm::dvec3 mapped =
      (glm::dvec3(texel) * 2.0 - 1.0) * glm::dvec3(material.normal_scale, material.normal_scale, 1);
  return glm::normalize(t * mapped.x + b * mapped.y + n * mapped.z);
}

TruthMaterial TruthGeometry::material_at(const Material& m, const Vertex* const (&corners)[3],
                                         const glm::dvec3& weights, const SeenTexel& texel) const {
  TruthMaterial out;
  const glm::dvec3 vertex_colour = mixed(corners, weights, [](const Vertex& v) { return glm::dvec3(v.colour); });
  out.base = glm::dvec3(texel.base) * colour_factor(glm::dvec3(m.base_colour), settings_.colour) * vertex_colour;
  if (settings_.albedo == AlbedoSource::white) out.base = glm::dvec3(1);
  if (settings_.reflections == Reflections::on && refracts(m)) {
    const double through = double(m.transmission) * (1 - double(texel.seen.w) * m.metal);  // no metal is clear
    out.through = through * out.base;
    out.base *= 1 - through;
  }
  out.metal = double(texel.seen.w) * m.metal;
  out.roughness = double(texel.seen.z) * m.roughness;
  const bool occluded = m.occlusion_texture.texture != kNoTexture;
  out.occlusion = 1 + (occluded ? m.occlusion_strength : 0) * (double(texel.normal.w) - 1);
  // Unlit: the display shows the colour as it is, whatever the exposure (KHR_materials_unlit).
  out.emission = m.unlit ? out.base / settings_.exposure : glm::dvec3(texel.emission) * glm::dvec3(m.emissive);
  out.unlit = m.unlit;
  // KHR_materials_ior and KHR_materials_specular: no material reflects more than all. The classic models' highlight is
  // scaled alike, and their factor may make more of it.
  const double of_index = reflectance_of_index(double(m.refraction_index));
  const glm::dvec3 colour = glm::dvec3(texel.specular) * colour_factor(glm::dvec3(m.specular_colour), settings_.colour);
  const glm::dvec3 of_common = glm::min(of_index * colour, glm::dvec3(1)) / kCommonReflectance;
  out.dielectric = model_.dielectric_f0 * of_common * double(m.specular) * double(texel.specular.w);
  return out;
}

SurfaceAt TruthGeometry::at(const Ray& ray, const SeenTexel& texel) const {
  const auto index = static_cast<size_t>(texel.instance());
  const Instance& instance = scene_.instances[index];
  const Placed& placed = placed_[index];
  const Mesh& mesh = scene_.meshes[static_cast<size_t>(instance.mesh)];
  const Material& material = scene_.materials[static_cast<size_t>(instance.material)];
  const Vertex* corners[3];
  glm::dvec3 places[3];
  for (size_t k = 0; k < 3; ++k) {
    corners[k] = &mesh.vertices[mesh.indices[3 * static_cast<size_t>(texel.triangle()) + k]];
    places[k] = glm::dvec3(placed.relative_from_object * glm::dvec4(corners[k]->position, 1));
  }
  const glm::dvec3 weights = barycentrics(ray, places);
  const bool anticlockwise = glm::dot(glm::cross(places[1] - places[0], places[2] - places[0]), ray.direction) < 0;
  SurfaceAt out;
  TruthSurface& s = out.surface;
  s.position = weights.x * places[0] + weights.y * places[1] + weights.z * places[2];
  s.position += heights_->sunk(ray, texel.surface()).by;
  s.to_eye = -glm::normalize(ray.origin == glm::dvec3(0) ? s.position : ray.direction);
  s.normal = shading_normal(placed, material, corners, weights, anticlockwise != placed.mirrored, texel.normal);

  TruthMaterial stored = material_at(material, corners, weights, texel);
  stored.normal = s.normal;
  if (store_) store_(stored);
  s.normal = stored.normal;
  s.roughness = stored.roughness;
  s.exponent = model_.exponent(s.roughness);
  s.unlit = stored.unlit;
  out.emission = stored.emission;
  if (stored.unlit) return out;
  s.albedo = stored.base * (1 - stored.metal);
  s.f0 = glm::mix(stored.dielectric, stored.base, stored.metal);
  // Ambient light has no direction: GGX sends it back by albedo and F0, the classic models by the base colour.
  out.ambient = stored.occlusion * (model_.model == ShadingModel::ggx ? s.albedo + s.f0 : stored.base);
  out.gloss = out.ambient - stored.occlusion * s.albedo;
  out.through = stored.through;
  return out;
}

}  // namespace gbl
