#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <vector>

#include "renderer/base/error.h"
#include "renderer/truth/ties.h"
#include "renderer/truth/visible_triangles.h"

namespace gbl {
namespace {

class Checker {
 public:
  Checker(const Settings& s, const Scene& scene) : settings_(s), scene_(scene) {
    const ViewRays rays = view_rays(s.camera, double(s.size.x) / s.size.y);
    half_ = {glm::length(rays.right), glm::length(rays.up)};
  }

  struct Triangle {
    glm::dvec3 places[3];  // relative to the camera
    bool masked = false;
  };

  bool exists(const SeenTexel& t) const {
    if (t.instance() < 0 || t.instance() >= static_cast<int>(scene_.instances.size()) || t.triangle() < 0) return false;
    return 3 * static_cast<size_t>(t.triangle()) + 2 < mesh_of(t).indices.size();
  }

  Triangle triangle_of(const SeenTexel& t) const {
    const Instance& placed = scene_.instances[static_cast<size_t>(t.instance())];
    const Mesh& mesh = mesh_of(t);
    glm::dmat4 relative_from_object = placed.world_from_object;
    relative_from_object[3] -= glm::dvec4(settings_.camera.position, 0);
    Triangle out;
    for (size_t k = 0; k < 3; ++k) {
      const Vertex& v = mesh.vertices[mesh.indices[3 * static_cast<size_t>(t.triangle()) + k]];
      out.places[k] = glm::dvec3(relative_from_object * glm::dvec4(glm::dvec3(v.position), 1));
    }
    out.masked = scene_.materials[static_cast<size_t>(placed.material)].alpha_mode == AlphaMode::mask;
    return out;
  }

  // Can this triangle be what the pixel shows, and before `nearest`, if there is one?
  bool may_be_seen(glm::ivec2 pixel, const Triangle& named, const Triangle* nearest) const {
    if (beside_px(pixel, named) > kRasterPx) return false;
    if (!nearest || range_at(pixel, named) <= (1 + kSameRange) * range_at(pixel, *nearest)) return true;
    return nearest->masked || border_px(pixel, *nearest) <= kRasterPx;
  }

 private:
  const Mesh& mesh_of(const SeenTexel& t) const {
    return scene_.meshes[static_cast<size_t>(scene_.instances[static_cast<size_t>(t.instance())].mesh)];
  }

  double range_of(const glm::dvec3& place) const { return glm::dot(place, settings_.camera.forward()); }

  // What of it lies before the eye: half the near plane's distance away, so that no edge of the cut is seen.
  std::vector<glm::dvec3> before_eye(const Triangle& t) const {
    const double least = settings_.camera.near / 2;
    std::vector<glm::dvec3> out;
    for (size_t k = 0; k < 3; ++k) {
      const glm::dvec3 &from = t.places[k], &to = t.places[(k + 1) % 3];
      const double a = range_of(from) - least, b = range_of(to) - least;
      if (a >= 0) out.push_back(from);
      if ((a >= 0) != (b >= 0)) out.push_back(from + (to - from) * (a / (a - b)));
    }
    return out;
  }

  // Its outline in pixels from the picture's upper left corner.
  std::vector<glm::dvec2> project(const Triangle& t) const {
    const Camera& c = settings_.camera;
    std::vector<glm::dvec2> out;
    for (const glm::dvec3& place :
         c.orthographic() ? std::vector<glm::dvec3>(std::begin(t.places), std::end(t.places)) : before_eye(t)) {
      const glm::dvec2 ndc = glm::dvec2(glm::dot(place, c.right()), glm::dot(place, c.up())) /
                             (half_ * (c.orthographic() ? 1 : range_of(place)));
      out.push_back((glm::dvec2(ndc.x, -ndc.y) + 1.0) / 2.0 * glm::dvec2(settings_.size));
    }
    return out;
  }

  // Distance of a point to the nearest edge; infinite of nothing.
  static double to_edges(const glm::dvec2& p, const std::vector<glm::dvec2>& c) {
    double nearest2 = INFINITY;
    for (size_t k = 0; k < c.size(); ++k) {
      const glm::dvec2 from = c[k], edge = c[(k + 1) % c.size()] - from;
      const double length2 = glm::dot(edge, edge);
      const double along = length2 > 0 ? std::clamp(glm::dot(p - from, edge) / length2, 0.0, 1.0) : 0;
      const glm::dvec2 off = from + along * edge - p;
      nearest2 = std::min(nearest2, glm::dot(off, off));
    }
    return std::sqrt(nearest2);
  }

  double border_px(glm::ivec2 pixel, const Triangle& t) const { return to_edges(glm::dvec2(pixel) + 0.5, project(t)); }

  // How far the pixel's centre lies beside the triangle; 0: on it.
  double beside_px(glm::ivec2 pixel, const Triangle& t) const {
    const Ray ray = pixel_ray(settings_.camera, settings_.size, pixel);
    const glm::dvec3 e1 = t.places[1] - t.places[0], e2 = t.places[2] - t.places[0];
    const glm::dvec3 p = glm::cross(ray.direction, e2), from = ray.origin - t.places[0], q = glm::cross(from, e1);
    const double determinant = glm::dot(e1, p);
    const double u = glm::dot(from, p) / determinant, v = glm::dot(ray.direction, q) / determinant;
    if (u >= 0 && v >= 0 && u + v <= 1 && glm::dot(e2, q) / determinant > 0) return 0;
    return border_px(pixel, t);
  }

  // Along the view axis, where the ray meets the triangle's plane; of one seen edge on, within its corners.
  double range_at(glm::ivec2 pixel, const Triangle& t) const {
    const Ray ray = pixel_ray(settings_.camera, settings_.size, pixel);
    const glm::dvec3 normal = glm::cross(t.places[1] - t.places[0], t.places[2] - t.places[0]);
    const double met = glm::dot(t.places[0] - ray.origin, normal) / glm::dot(ray.direction, normal);
    double low = INFINITY, high = -INFINITY;
    for (const glm::dvec3& p : t.places) {
      const double range = range_of(p);
      low = std::min(low, range), high = std::max(high, range);
    }
    return std::isfinite(met) ? std::clamp(met, low, high) : low;
  }

  const Settings& settings_;
  const Scene& scene_;
  glm::dvec2 half_{1};  // of the picture, at distance 1 along the axis
};

}  // namespace

size_t check_triangles(const Settings& s, const Scene& scene, std::vector<SeenTexel>& texels) {
  const std::vector<SeenTexel> found = visible_triangles(s, scene, false);
  const Checker checker(s, scene);
  size_t replaced = 0;
  for (size_t i = 0; i < texels.size(); ++i) {
    SeenTexel& named = texels[i];
    if (named.instance() < 0) continue;
    const bool same = named.instance() == found[i].instance() && named.triangle() == found[i].triangle();
    if (same) continue;
    const glm::ivec2 pixel(static_cast<int>(i) % s.size.x, static_cast<int>(i) / s.size.x);
    std::optional<Checker::Triangle> nearest;
    if (found[i].instance() >= 0) nearest = checker.triangle_of(found[i]);
    const Checker::Triangle* before = nearest ? &*nearest : nullptr;
    if (checker.exists(named) && checker.may_be_seen(pixel, checker.triangle_of(named), before)) continue;
    if (!before)
      throw Error(ExitCode::unfinished, "reference",
                  fmt::format("the driver names object {}, triangle {} at pixel {}, {}, where no surface is",
                              named.instance() + 1, named.triangle(), pixel.x, pixel.y),
                  "no error can be measured on this driver; report it with the scene");
    named.seen.x = found[i].seen.x, named.seen.y = found[i].seen.y;
    ++replaced;
  }
  return replaced;
}

}  // namespace gbl
