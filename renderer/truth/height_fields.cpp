#include "renderer/truth/height_fields.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/base/threads.h"
#include "renderer/truth/texture_levels.h"

namespace gbl {
namespace {

// A line that is nearly along the plane would cross more patches than this; it is left where it is.
constexpr double kMostPatches = 1e6;
constexpr double kFarthestTexel = 1e9;  // beyond it a texel's number is none of an int

// f(s) = a s^2 + b s + c through three places of a patch.
struct Parabola {
  double a, b, c;
  static Parabola through(double start, double middle, double end) {
    return {2 * (start + end - 2 * middle), 4 * middle - 3 * start - end, start};
  }
  // The least s in 0..1 where it rises to 0, from below. `after`: where roots begin to count.
  std::optional<double> first_root(double after) const {
    const double discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return std::nullopt;
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    std::optional<double> first;
    for (const double s : {a != 0 ? q / a : INFINITY, q != 0 ? c / q : INFINITY})
      if (s >= after && s <= 1 && (!first || s < *first)) first = s;
    return first;
  }
};

// Walks a line through the patches of a grid, in texels: from + t * along, t = 0..1. visit(from, to) of each; true: no more.
template <class Visit>
bool over_patches(const glm::dvec2& from, const glm::dvec2& along, Visit visit) {
  double next[2], step[2];
  for (int k = 0; k < 2; ++k) {
    step[k] = along[k] == 0 ? INFINITY : 1 / std::abs(along[k]);
    const double edge = along[k] > 0 ? std::floor(from[k]) + 1 : std::ceil(from[k]) - 1;
    next[k] = along[k] == 0 ? INFINITY : (edge - from[k]) / along[k];
  }
  for (double t = 0; t < 1;) {
    const double to = std::min({next[0], next[1], 1.0});
    if (to > t && visit(t, to)) return true;
    for (int k = 0; k < 2; ++k)
      if (next[k] <= to) next[k] += step[k];
    t = to;
  }
  return false;
}

}  // namespace

HeightFields::HeightFields(const Settings& s, const Scene& scene) : scene_(scene), camera_(s.camera.position) {
  if (s.height_map == HeightMap::off) return;
  if (std::none_of(scene.materials.begin(), scene.materials.end(), has_heights)) return;
  for (const Material& m : scene.materials) {
    maps_.emplace_back();
    if (!has_heights(m)) continue;
    const Texture& t = scene.textures[static_cast<size_t>(m.height_texture.texture)];
    Map& map = maps_.back().emplace(Map{t.size, {}, double(m.height_depth), t.sampler.wrap_u, t.sampler.wrap_v});
    for (size_t i = 0; i < static_cast<size_t>(t.size.x) * static_cast<size_t>(t.size.y); ++i)
      map.depths.push_back(1 - t.texel(i).r);
  }
}

double HeightFields::Map::at(glm::ivec2 texel) const {
  const int x = wrapped_texel(texel.x, size.x, wrap_u), y = wrapped_texel(texel.y, size.y, wrap_v);
  return depths[static_cast<size_t>(y) * static_cast<size_t>(size.x) + static_cast<size_t>(x)];
}

double HeightFields::Map::at(const glm::dvec2& texel) const {
  const glm::dvec2 low = glm::floor(texel), share = texel - low;
  const glm::ivec2 i(low);
  return glm::mix(glm::mix(at(i), at(i + glm::ivec2(1, 0)), share.x),
                  glm::mix(at(i + glm::ivec2(0, 1)), at(i + glm::ivec2(1, 1)), share.x), share.y);
}

const HeightFields::Map* HeightFields::map_of(const SeenSurface& s) const {
  if (maps_.empty() || s.object < 1) return nullptr;
  const auto& map = maps_[static_cast<size_t>(scene_.instances[static_cast<size_t>(s.object - 1)].material)];
  return map ? &*map : nullptr;
}

HeightFields::Plane HeightFields::plane_of(const SeenSurface& s) const {
  const Instance& in = scene_.instances[static_cast<size_t>(s.object - 1)];
  const Mesh& mesh = scene_.meshes[static_cast<size_t>(in.mesh)];
  glm::dmat4 relative_from_object = in.world_from_object;
  relative_from_object[3] -= glm::dvec4(camera_, 0);
  glm::dvec3 place[3];
  glm::dvec2 uv[3];
  for (size_t k = 0; k < 3; ++k) {
    const Vertex& v = mesh.vertices[mesh.indices[3 * static_cast<size_t>(s.triangle) + k]];
    place[k] = relative_from_object * glm::dvec4(glm::dvec3(v.position), 1);
    uv[k] = v.uv;
  }
  const glm::dvec3 e1 = place[1] - place[0], e2 = place[2] - place[0], area = glm::cross(e1, e2);
  const double mirrored = glm::determinant(glm::dmat3(in.world_from_object)) < 0 ? -1 : 1;
  Plane p{place[0], glm::normalize(area) * mirrored, uv[0], {}, {}};
  const glm::dvec3 first = glm::cross(e2, area) / glm::dot(area, area),
                   second = glm::cross(area, e1) / glm::dot(area, area);
  const glm::dvec2 d1 = uv[1] - uv[0], d2 = uv[2] - uv[0];
  p.along_u = d1.x * first + d2.x * second;
  p.along_v = d1.y * first + d2.y * second;
  return p;
}

Sunk HeightFields::sunk(const Ray& ray, const SeenSurface& surface) const {
  const Map* map = map_of(surface);
  if (!map) return {};
  const Plane p = plane_of(surface);
  const double cosine = -glm::dot(p.normal, ray.direction);
  if (!(cosine > 0)) return {};
  // Down to the lowest place.
  const glm::dvec3 met = ray.origin + glm::dot(p.normal, p.corner - ray.origin) / -cosine * ray.direction;
  const glm::dvec3 way = map->depth / cosine * ray.direction;
  const glm::dvec2 texels(map->size), from = (p.uv + p.uv_by(met - p.corner)) * texels - 0.5,
                                      along = p.uv_by(way) * texels;
  if (!(std::abs(along.x) + std::abs(along.y) < kMostPatches) ||
      !(std::abs(from.x) + std::abs(from.y) < kFarthestTexel))
    return {};
  double share = 1;
  over_patches(from, along, [&](double t0, double t1) {
    const auto below = [&](double t) { return t - map->at(from + t * along); };  // > 0: in the solid
    const Parabola f = Parabola::through(below(t0), below(0.5 * (t0 + t1)), below(t1));
    const std::optional<double> s = f.c >= 0 ? 0.0 : f.first_root(0);
    if (s) share = t0 + *s * (t1 - t0);
    return s.has_value();
  });
  return {share * way, share * along / texels};
}

std::optional<HeightFields::Way> HeightFields::way_out(const glm::dvec3& place, const glm::dvec3& to_light,
                                                       const SeenSurface& surface) const {
  const Map* map = map_of(surface);
  if (!map) return Way{place, false};
  const Plane p = plane_of(surface);
  const double deep = glm::dot(p.normal, p.corner - place) / map->depth;  // share of the depth
  constexpr double kOnThePlane = 1e-9;
  if (!(deep > kOnThePlane)) return Way{place, false};  // as flat as its triangle: there, or where its back is seen
  const double cosine = glm::dot(p.normal, to_light);
  if (!(cosine > 0)) return std::nullopt;
  const glm::dvec3 way = deep * map->depth / cosine * to_light;
  const glm::dvec2 texels(map->size), from = (p.uv + p.uv_by(place - p.corner)) * texels - 0.5,
                                      along = p.uv_by(way) * texels;
  if (!(std::abs(along.x) + std::abs(along.y) < kMostPatches) ||
      !(std::abs(from.x) + std::abs(from.y) < kFarthestTexel))
    return std::nullopt;
  bool first = true;
  const bool hidden = over_patches(from, along, [&](double t0, double t1) {
    const auto below = [&](double t) { return deep * (1 - t) - map->at(from + t * along); };
    Parabola f = Parabola::through(below(t0), below(0.5 * (t0 + t1)), below(t1));
    // It begins on the surface, up to rounding; from there on it has to stay above.
    if (std::exchange(first, false)) f.c = 0;
    constexpr double kRounding = 1e-12;
    const double crest = f.a < 0 ? std::clamp(-0.5 * f.b / f.a, 0.0, 1.0) : 1.0;
    return f.a * crest * crest + f.b * crest + f.c > kRounding;
  });
  if (hidden) return std::nullopt;
  return Way{place + way, true};
}

std::vector<glm::vec4> uvs_moved(const HeightFields& fields, const Settings& s, const std::vector<SeenTexel>& texels,
                                 int threads, const std::atomic<bool>* cancel) {
  std::vector<glm::vec4> out(texels.size(), glm::vec4(0));
  const auto work = [&](int first) {
    for (int y = first; y < s.size.y && !(cancel && *cancel); y += threads)
      for (int x = 0; x < s.size.x; ++x) {
        const size_t i = static_cast<size_t>(y) * static_cast<size_t>(s.size.x) + static_cast<size_t>(x);
        if (texels[i].instance() < 0) continue;
        const Sunk sunk = fields.sunk(pixel_ray(s.camera, s.size, {x, y}), texels[i].surface());
        out[i] = glm::vec4(glm::vec2(sunk.uv_moved), 0, 0);
      }
  };
  on_threads(threads, work);
  return out;
}

}  // namespace gbl
