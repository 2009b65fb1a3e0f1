#include "renderer/truth/mirror_sight.h"

#include "renderer/reflection/mirrors.h"
#include "renderer/truth/texture_at.h"

namespace gbl {
namespace {

const Material& material_of(const Scene& scene, int object) {
  return scene.materials[static_cast<size_t>(scene.instances[static_cast<size_t>(object - 1)].material)];
}

}  // namespace

SeenTexel texels_of(const SurfaceHit& hit, const Scene& scene, const Settings& s) {
  const Instance& in = scene.instances[static_cast<size_t>(hit.surface.object - 1)];
  const Mesh& mesh = scene.meshes[static_cast<size_t>(in.mesh)];
  const Material& m = material_of(scene, hit.surface.object);
  const TextureAt at(mesh, &mesh.indices[3 * static_cast<size_t>(hit.surface.triangle)], hit.weights);
  const bool srgb = s.colour == Colour::srgb;
  const glm::dvec4 rough_metal = at.linear(scene, m.roughness_texture, false);
  const double occlusion = at.linear(scene, m.occlusion_texture, false).r;
  SeenTexel out;
  out.seen = {hit.surface.object, hit.surface.triangle, rough_metal.g, rough_metal.b};
  out.base = at.linear(scene, m.base_colour_texture, srgb);
  out.normal = glm::dvec4(glm::dvec3(at.linear(scene, m.normal_texture, false)), occlusion);
  out.emission = at.linear(scene, m.emissive_texture, srgb);
  out.specular = glm::dvec4(glm::dvec3(at.linear(scene, m.specular_colour_texture, srgb)),
                            at.linear(scene, m.specular_texture, false).a);
  return out;
}

MirrorSight::MirrorSight(const Settings& s, const Scene& scene, std::shared_ptr<const RayScene> rays)
    : settings_(s), scene_(scene) {
  if (s.reflections == Reflections::off) return;
  bool any = false;
  for (int object = 1; object <= static_cast<int>(scene.instances.size()); ++object) {
    const Material& m = material_of(scene, object);
    any |= is_mirror(m);
    if (refracts(m)) within_.try_emplace(object, scene, object);
  }
  if (any) rays_ = rays ? std::move(rays) : std::make_shared<const RayScene>(scene);
}

bool MirrorSight::mirrors(const SeenSurface& s) const { return rays_ && is_mirror(material_of(scene_, s.object)); }

Ray MirrorSight::mirrored_ray(const TruthSurface& s) {
  return {s.position, glm::normalize(2 * glm::dot(s.normal, s.to_eye) * s.normal - s.to_eye)};
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

Through MirrorSight::refracted_ray(const TruthSurface& s, const SeenSurface& surface) const {
  const double index = std::max(double(material_of(scene_, surface.object).refraction_index), 1.0);
  const RayScene& own = within_.at(surface.object);
  glm::dvec3 place = s.position + settings_.camera.position;
  glm::dvec3 direction = glm::refract(-s.to_eye, s.normal, 1 / index);
  for (int k = 0; k < kMostWithin; ++k) {
    const auto hit = own.first_hit({place, direction, own.least_distance(place), kEndless});
    if (!hit) return {{place - settings_.camera.position, direction}};  // not closed: as a thin sheet
    place += hit->distance * direction;
    glm::dvec3 inwards = normal_at(*hit);
    if (glm::dot(inwards, direction) > 0) inwards = -inwards;
    const glm::dvec3 out = glm::refract(direction, inwards, index);
    if (out != glm::dvec3(0)) {
      const double lost = fresnel(glm::dvec3(reflectance_of_index(index)), glm::dot(-inwards, out)).x;
      return {{place - settings_.camera.position, out}, 1 - lost};
    }
    direction = glm::reflect(direction, inwards);
  }
  return {{place - settings_.camera.position, direction}, 0};
}

std::optional<SeenTexel> MirrorSight::seen(const Ray& ray, const SeenSurface& from) const {
  const glm::dvec3 place = ray.origin + settings_.camera.position;
  RayPart part{place, ray.direction, rays_->least_distance(place), kEndless};
  std::optional<SurfaceHit> hit = rays_->first_hit(part);
  while (hit && hit->surface.object == from.object && hit->from_behind) {
    part.from = hit->distance;
    hit = rays_->first_hit(part);
  }
  return hit ? std::optional(texels_of(*hit, scene_, settings_)) : std::nullopt;
}

}  // namespace gbl
