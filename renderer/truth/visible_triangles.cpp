#include "renderer/truth/visible_triangles.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/threads.h"
#include "renderer/picture/srgb.h"
#include "renderer/reflection/mirrors.h"
#include "renderer/truth/texture_at.h"

namespace gbl {
namespace {

glm::dvec3 linear(const glm::dvec4& coded) {
  return {linear_from_srgb(coded.x), linear_from_srgb(coded.y), linear_from_srgb(coded.z)};
}

// The weights of a triangle's corners are linear in the picture's coordinates, up to a common factor: perspective or
// orthographic (Olano and Greer 1997, "Triangle Scan Conversion using 2D Homogeneous Coordinates").
struct Edges {
  glm::dvec3 at_centre, per_x, per_y;  // the three weights; x and y in normalised device coordinates
  glm::dvec3 ranges;                   // of the corners, along the view axis
  glm::ivec2 from{0}, to{0};           // pixels whose centres it may cover; to: one beyond
};

struct Hit {
  int instance = -1;
  uint32_t triangle = 0;
  double range = INFINITY;
  glm::dvec3 weights{0};
  SeenSurface surface() const { return {instance + 1, static_cast<int>(triangle)}; }
};

// Rows `from` up to `to` of the picture.
class Band {
 public:
  Band(const Settings& s, const Scene& scene, bool back_faces_too, glm::dvec2 aside_px, int from, int to)
      : settings_(s),
        scene_(scene),
        back_faces_too_(back_faces_too),
        centre_(0.5 + aside_px),
        from_(from),
        to_(to),
        rays_(view_rays(s.camera, double(s.size.x) / s.size.y)) {
    hits_.resize(static_cast<size_t>(to - from) * static_cast<size_t>(s.size.x));
  }

  std::vector<Hit> nearest() {
    find_nearest();
    return std::move(hits_);
  }

  // The nearest, and those at most this share of its range behind it.
  std::vector<Rival> first_ones(double same_range) {
    std::vector<Rival> out;
    const size_t before = static_cast<size_t>(from_) * static_cast<size_t>(settings_.size.x);
    const auto add = [&](size_t pixel, const Hit& hit) { out.push_back({before + pixel, hit.surface()}); };
    find_nearest();
    for (size_t i = 0; i < hits_.size(); ++i)
      if (hits_[i].instance < 0) add(i, hits_[i]);
    const auto near = [&](const Hit& hit, const Hit& nearest) { return hit.range <= (1 + same_range) * nearest.range; };
    for (size_t i = 0; i < scene_.instances.size(); ++i) draw(i, near, add);
    return out;
  }

 private:
  void find_nearest() {
    const auto nearer = [](const Hit& hit, const Hit& nearest) { return hit.range < nearest.range; };
    for (size_t i = 0; i < scene_.instances.size(); ++i)
      draw(i, nearer, [&](size_t pixel, const Hit& hit) { hits_[pixel] = hit; });
  }

  // use(pixel, hit) of all hits that are wanted(hit, hits_[pixel]).
  template <class Wanted, class Use>
  void draw(size_t index, Wanted wanted, Use use) {
    const Instance& placed = scene_.instances[index];
    const Mesh& mesh = scene_.meshes[static_cast<size_t>(placed.mesh)];
    const Material& material = scene_.materials[static_cast<size_t>(placed.material)];
    if (blends(material, settings_.reflections == Reflections::on))
      return;  // never stored, so never seen by a G-buffer
    glm::dmat4 relative_from_object = placed.world_from_object;
    relative_from_object[3] -= glm::dvec4(settings_.camera.position, 0);
    const bool mirrored = glm::determinant(glm::dmat3(relative_from_object)) < 0;
    const auto place = [&](uint32_t vertex) {
      return glm::dvec3(relative_from_object * glm::dvec4(glm::dvec3(mesh.vertices[vertex].position), 1));
    };
    for (uint32_t t = 0; 3 * static_cast<size_t>(t) < mesh.indices.size(); ++t) {
      const uint32_t* corner = &mesh.indices[3 * static_cast<size_t>(t)];
      const Edges e = edges_of(place(corner[0]), place(corner[1]), place(corner[2]));
      for (int y = e.from.y; y < e.to.y; ++y)
        for (int x = e.from.x; x < e.to.x; ++x) {
          Hit hit{static_cast<int>(index), t};
          const size_t pixel =
              static_cast<size_t>(y - from_) * static_cast<size_t>(settings_.size.x) + static_cast<size_t>(x);
          if (meets(e, x, y, material.double_sided || back_faces_too_, mirrored, hit) && wanted(hit, hits_[pixel]) &&
              !in_hole(scene_, mesh, corner, material, hit.weights))
            use(pixel, hit);
        }
    }
  }

  Edges edges_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const {
    const Camera& camera = settings_.camera;
    Edges e;
    e.ranges = {glm::dot(a, camera.forward()), glm::dot(b, camera.forward()), glm::dot(c, camera.forward())};
    const double nearest = std::min({e.ranges.x, e.ranges.y, e.ranges.z});
    const double farthest = std::max({e.ranges.x, e.ranges.y, e.ranges.z});
    if (!(farthest > camera.near && nearest < camera.far)) return e;
    // The part beyond the near plane: its corners, and where its edges are cut.
    glm::dvec2 low(INFINITY), high(-INFINITY);
    const auto include = [&](const glm::dvec3& p, double range) {
      const glm::dvec2 ndc = on_picture(p, range);
      low = glm::min(low, ndc), high = glm::max(high, ndc);
    };
    const glm::dvec3* corners[3] = {&a, &b, &c};
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      const double from = e.ranges[k] - camera.near, to = e.ranges[next] - camera.near;
      if (from >= 0) include(*corners[k], e.ranges[k]);
      if ((from < 0) != (to < 0)) include(glm::mix(*corners[k], *corners[next], from / (from - to)), camera.near);
    }
    const auto pixel = [](double at, int least, int most) {
      return static_cast<int>(std::clamp(at, double(least), double(most)));
    };
    const glm::dvec2 size(settings_.size);
    e.from = {pixel(std::ceil((low.x + 1) / 2 * size.x - centre_.x), 0, settings_.size.x),
              pixel(std::ceil((1 - high.y) / 2 * size.y - centre_.y), from_, to_)};
    e.to = {pixel(std::floor((high.x + 1) / 2 * size.x - centre_.x) + 1, 0, settings_.size.x),
            pixel(std::floor((1 - low.y) / 2 * size.y - centre_.y) + 1, from_, to_)};
    const glm::dvec3 sides[3] = {glm::cross(b, c), glm::cross(c, a), glm::cross(a, b)};
    if (camera.orthographic()) {
      // The ray starts aside of the eye: the corners are seen from there, (b - o) x (c - o) . forward.
      const glm::dvec3 opposite[3] = {c - b, a - c, b - a};
      for (int k = 0; k < 3; ++k) {
        const glm::dvec3 turned = glm::cross(opposite[k], rays_.forward);
        e.at_centre[k] = glm::dot(sides[k], rays_.forward);
        e.per_x[k] = -glm::dot(rays_.right, turned), e.per_y[k] = -glm::dot(rays_.up, turned);
      }
    } else {
      for (int k = 0; k < 3; ++k) {
        e.at_centre[k] = glm::dot(sides[k], rays_.forward);
        e.per_x[k] = glm::dot(sides[k], rays_.right), e.per_y[k] = glm::dot(sides[k], rays_.up);
      }
    }
    return e;
  }

  glm::dvec2 on_picture(const glm::dvec3& p, double range) const {
    const double scale = settings_.camera.orthographic() ? 1 : range;
    return {glm::dot(p, rays_.right) / glm::dot(rays_.right, rays_.right) / scale,
            glm::dot(p, rays_.up) / glm::dot(rays_.up, rays_.up) / scale};
  }

  bool meets(const Edges& e, int x, int y, bool double_sided, bool mirrored, Hit& hit) const {
    const glm::dvec2 at = (glm::dvec2(x, y) + centre_) / glm::dvec2(settings_.size);
    const double ndc_x = at.x * 2 - 1, ndc_y = 1 - at.y * 2;
    const glm::dvec3 w = e.at_centre + ndc_x * e.per_x + ndc_y * e.per_y;
    const bool back = w.x >= 0 && w.y >= 0 && w.z >= 0, front = w.x <= 0 && w.y <= 0 && w.z <= 0;
    const double sum = w.x + w.y + w.z;  // against the normal where it faces us
    if (!(back || front) || sum == 0) return false;
    if (!double_sided && (sum < 0) == mirrored) return false;
    hit.weights = w / sum;
    hit.range = glm::dot(hit.weights, e.ranges);
    return hit.range > settings_.camera.near && hit.range < settings_.camera.far;
  }

  const Settings& settings_;
  const Scene& scene_;
  const bool back_faces_too_;
  const glm::dvec2 centre_;  // of a pixel, from its upper left corner: where its ray passes
  const int from_, to_;
  const ViewRays rays_;
  std::vector<Hit> hits_;
};

// What `of` finds in each band of the picture, from top to bottom.
template <class Of>
auto in_bands(const Settings& s, const Scene& scene, bool back_faces_too, glm::dvec2 aside_px, Of of) {
  const int count = std::min(all_processors(), s.size.y);
  std::vector<decltype(of(std::declval<Band&>()))> parts(static_cast<size_t>(count));
  on_threads(count, [&](int k) {
    Band band(s, scene, back_faces_too, aside_px, s.size.y * k / count, s.size.y * (k + 1) / count);
    parts[static_cast<size_t>(k)] = of(band);
  });
  for (size_t k = 1; k < parts.size(); ++k) {
    parts[0].insert(parts[0].end(), parts[k].begin(), parts[k].end());
    parts[k] = {};
  }
  return std::move(parts[0]);
}

std::vector<Hit> hits_of(const Settings& s, const Scene& scene, bool back_faces_too) {
  return in_bands(s, scene, back_faces_too, {0, 0}, [](Band& band) { return band.nearest(); });
}

SeenTexel texel_of(const Hit& hit, const Scene& scene, Colour colour) {
  SeenTexel seen;
  if (hit.instance < 0) return seen;
  const Instance& placed = scene.instances[static_cast<size_t>(hit.instance)];
  const Mesh& mesh = scene.meshes[static_cast<size_t>(placed.mesh)];
  const Material& m = scene.materials[static_cast<size_t>(placed.material)];
  const TextureAt at(mesh, &mesh.indices[3 * static_cast<size_t>(hit.triangle)], hit.weights);
  const auto colour_of = [&](const TextureUse& use) {
    const glm::dvec4 texel = at.nearest(scene, use);
    return colour == Colour::as_tutorial ? glm::dvec3(texel) : linear(texel);
  };
  const glm::dvec4 base = at.nearest(scene, m.base_colour_texture), rough = at.nearest(scene, m.roughness_texture);
  seen.seen = glm::vec4(hit.instance + 1, hit.triangle, rough.y, rough.z);
  seen.base = glm::vec4(colour_of(m.base_colour_texture), base.a);
  seen.normal = glm::vec4(0.5f, 0.5f, 1, at.nearest(scene, m.occlusion_texture).x);
  seen.emission = glm::vec4(linear(at.nearest(scene, m.emissive_texture)), 0);
  seen.specular = glm::vec4(colour_of(m.specular_colour_texture), at.nearest(scene, m.specular_texture).w);
  return seen;
}

}  // namespace

bool sees_surface(const Settings& s, const Scene& scene, bool back_faces_too) {
  const std::vector<Hit> hits = hits_of(s, scene, back_faces_too);
  return std::any_of(hits.begin(), hits.end(), [](const Hit& h) { return h.instance >= 0; });
}

std::vector<Rival> seen_aside(const Settings& s, const Scene& scene, glm::dvec2 aside_px, double same_range) {
  return in_bands(s, scene, false, aside_px, [&](Band& band) { return band.first_ones(same_range); });
}

std::vector<SeenTexel> visible_triangles(const Settings& s, const Scene& scene, bool with_textures) {
  const std::vector<Hit> hits = hits_of(s, scene, false);
  std::vector<SeenTexel> seen(hits.size());
  for (size_t i = 0; i < hits.size(); ++i)
    if (with_textures)
      seen[i] = texel_of(hits[i], scene, s.colour);
    else
      seen[i].seen = glm::vec4(hits[i].instance + 1, hits[i].triangle, 0, 0);
  return seen;
}

}  // namespace gbl
