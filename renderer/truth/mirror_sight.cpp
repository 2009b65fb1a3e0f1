#include "renderer/truth/mirror_sight.h"

#include "renderer/reflection/mirrors.h"
#include "renderer/truth/texture_at.h"

namespace gbl {
namespace {

const Material& material_of(const Scene& scene, int object) {
  return scene.materials[static_cast<size_t>(scene.instances[static_cast<size_t>(object - 1)].material)];
}

// Weights of the corners where a ray meets the triangle's plane, inside or not (Moeller and Trumbore 1997).
glm::dvec3 weights_on_plane(const Ray& ray, const glm::dvec3 (&c)[3]) {
  const glm::dvec3 e1 = c[1] - c[0], e2 = c[2] - c[0], from = ray.origin - c[0];
  const glm::dvec3 p = glm::cross(ray.direction, e2), q = glm::cross(from, e1);
  const double determinant = glm::dot(e1, p);
  const double u = glm::dot(from, p) / determinant, v = glm::dot(ray.direction, q) / determinant;
  return {1 - u - v, u, v};
}

}  // namespace

MirrorSight::MirrorSight(const Settings& s, const Scene& scene, std::shared_ptr<const RayScene> rays,
                         std::shared_ptr<const HeightFields> heights)
    : settings_(s), scene_(scene), heights_(std::move(heights)) {
  if (s.reflections == Reflections::off) return;
  bool any = false;
  for (int object = 1; object <= static_cast<int>(scene.instances.size()); ++object) {
    const Material& m = material_of(scene, object);
    any |= is_mirror(m);
    if (refracts(m)) within_.try_emplace(object, scene, object);
  }
  if (!any) return;
  rays_ = rays ? std::move(rays) : std::make_shared<const RayScene>(scene);
  textures_.emplace(scene, s.colour == Colour::srgb);
}

bool MirrorSight::mirrors(const SeenSurface& s) const { return rays_ && is_mirror(material_of(scene_, s.object)); }

// A mirror as flat as its tangent plane: exact for the footprint of a flat one.
RayBundle MirrorSight::mirrored_rays(const TruthSurface& s, glm::ivec2 pixel) const {
  const auto next = [&](glm::ivec2 by) -> Ray {
    const Ray r = pixel_ray(settings_.camera, settings_.size, pixel + by);
    const double along = glm::dot(s.normal, s.position - r.origin) / glm::dot(s.normal, r.direction);
    return {r.origin + along * r.direction, glm::reflect(r.direction, s.normal)};
  };
  return {{s.position, glm::normalize(glm::reflect(-s.to_eye, s.normal))}, next({1, 0}), next({0, 1})};
}

RayBundle MirrorSight::spread(const Ray& ray, double distance) const {
  const Ray middle = pixel_ray(settings_.camera, settings_.size, {0, 0}),
            next = pixel_ray(settings_.camera, settings_.size, {1, 0});
  const double wide = settings_.camera.orthographic() ? 0 : glm::length(next.direction - middle.direction);
  const double start = settings_.camera.orthographic() ? glm::length(next.origin - middle.origin) : wide * distance;
  const glm::dvec3 other = std::abs(ray.direction.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(ray.direction, other)), v = glm::cross(ray.direction, u);
  const auto aside = [&](const glm::dvec3& by) { return Ray{ray.origin + start * by, ray.direction + wide * by}; };
  return {ray, aside(u), aside(v)};
}

SeenTexel MirrorSight::texels_of(const SurfaceHit& hit, const RayBundle& rays) const {
  const Instance& in = scene_.instances[static_cast<size_t>(hit.surface.object - 1)];
  const Mesh& mesh = scene_.meshes[static_cast<size_t>(in.mesh)];
  const Material& m = material_of(scene_, hit.surface.object);
  const uint32_t* corner = &mesh.indices[3 * static_cast<size_t>(hit.surface.triangle)];
  glm::dmat4 relative_from_object = in.world_from_object;
  relative_from_object[3] -= glm::dvec4(settings_.camera.position, 0);
  glm::dvec3 places[3];
  for (size_t k = 0; k < 3; ++k)
    places[k] = relative_from_object * glm::dvec4(glm::dvec3(mesh.vertices[corner[k]].position), 1);
  TextureAt at(mesh, corner, hit.weights);
  const TextureAt beside(mesh, corner, weights_on_plane(rays.beside, places)),
      below(mesh, corner, weights_on_plane(rays.below, places));
  // As large as seen on the flat surface, where it is seen below it.
  const TextureAt flat = at;
  at.uv[0] += heights_->sunk(rays.ray, hit.surface).uv_moved;
  const auto read = [&](const TextureUse& use, bool srgb) {
    const glm::dvec2 uv = flat.uv_of(use);
    return textures_->at(use.texture, srgb, at.uv_of(use), beside.uv_of(use) - uv, below.uv_of(use) - uv);
  };
  const bool srgb = settings_.colour == Colour::srgb;
  const glm::dvec4 rough_metal = read(m.roughness_texture, false);
  SeenTexel out;
  out.seen = {hit.surface.object, hit.surface.triangle, rough_metal.g, rough_metal.b};
  out.base = read(m.base_colour_texture, srgb);
  out.normal = glm::dvec4(glm::dvec3(read(m.normal_texture, false)), read(m.occlusion_texture, false).r);
  out.emission = read(m.emissive_texture, srgb);
  out.specular = glm::dvec4(glm::dvec3(read(m.specular_colour_texture, srgb)), read(m.specular_texture, false).a);
  return out;
}

glm::dvec3 MirrorSight::normal_at(const SurfaceHit& hit) const {
  const Instance& in = scene_.instances[static_cast<size_t>(hit.surface.object - 1)];
  const Mesh& mesh = scene_.meshes[static_cast<size_t>(in.mesh)];
  glm::dvec3 n(0);
  for (size_t k = 0; k < 3; ++k)
    n += hit.weights[static_cast<int>(k)] *
         glm::dvec3(mesh.vertices[mesh.indices[3 * static_cast<size_t>(hit.surface.triangle) + k]].normal);
  return glm::normalize(glm::transpose(glm::inverse(glm::dmat3(in.world_from_object))) * n);
}

Through MirrorSight::refracted_rays(const TruthSurface& s, const SeenSurface& surface) const {
  const double index = std::max(double(material_of(scene_, surface.object).refraction_index), 1.0);
  const RayScene& own = within_.at(surface.object);
  glm::dvec3 place = s.position + settings_.camera.position;
  double come = glm::length(s.position);
  const auto bundle = [&](const glm::dvec3& out) { return spread({place - settings_.camera.position, out}, come); };
  glm::dvec3 direction = glm::refract(-s.to_eye, s.normal, 1 / index);
  for (int k = 0; k < kMostWithin; ++k) {
    const auto hit = own.first_hit({place, direction, own.least_distance(place), kEndless});
    if (!hit) return {bundle(direction)};  // not closed: bent once
    place += hit->distance * direction, come += hit->distance;
    glm::dvec3 inwards = normal_at(*hit);
    if (glm::dot(inwards, direction) > 0) inwards = -inwards;
    const glm::dvec3 out = glm::refract(direction, inwards, index);
    if (out != glm::dvec3(0)) {
      const double lost = fresnel(glm::dvec3(reflectance_of_index(index)), glm::dot(-inwards, out)).x;
      return {bundle(out), 1 - lost};
    }
    direction = glm::reflect(direction, inwards);
  }
  return {bundle(direction), 0};
}

std::optional<SeenTexel> MirrorSight::seen(const RayBundle& rays, const SeenSurface& from) const {
  const Ray& ray = rays.ray;
  const glm::dvec3 place = ray.origin + settings_.camera.position;
  RayPart part{place, ray.direction, rays_->least_distance(place), kEndless};
  std::optional<SurfaceHit> hit = rays_->first_hit(part);
  const auto culled = [&](const SurfaceHit& h) {
    return h.from_behind && (h.surface.object == from.object || !material_of(scene_, h.surface.object).double_sided);
  };
  while (hit && culled(*hit)) {
    part.from = hit->distance;
    hit = rays_->first_hit(part);
  }
  return hit ? std::optional(texels_of(*hit, rays)) : std::nullopt;
}

}  // namespace gbl
