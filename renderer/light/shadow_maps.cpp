#include "renderer/light/shadow_maps.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace gbl {
namespace {

constexpr double kNearShare = 1e-3;  // the near plane of a point or spot light's map, of its far plane
constexpr double kWidestSpot = 1.4;  // radians off its axis, beyond which one map has no room: it is cut there
constexpr double kFilterTexels = 2;  // of a map's border, so that a filter finds its neighbours

// Rows: right, up, back of a view along this direction.
glm::dmat3 view_along(const glm::dvec3& direction, const glm::dvec3& up) {
  const glm::dvec3 back = -glm::normalize(direction), right = glm::normalize(glm::cross(up, back));
  return glm::transpose(glm::dmat3(right, glm::cross(back, right), back));
}
// Any direction that is not along `direction`: looking along the up vector gives a matrix of NaN (`cube-lookat-up`).
glm::dvec3 some_up(const glm::dvec3& direction) {
  return std::abs(direction.y) < 0.9 * glm::length(direction) ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
}

// Rounded up to ten binary digits, so that what is all but equal is equal.
double rounded_up(double x) {
  const double step = std::exp2(std::floor(std::log2(x)) - 10);
  return std::ceil(x / step) * step;
}

struct Planner {
  const Camera& camera;
  double aspect;
  const Bounds& scene;
  const ShadowWishes& wishes;
  glm::dvec3 anchor;

  double farthest_from(const glm::dvec3& place) const {
    double far = 0;
    for (const glm::dvec3& c : corners_of(scene)) far = std::max(far, glm::distance(place, c));
    return far;
  }

  ShadowMap perspective(int light, const Light& l, const glm::dmat3& view, double tan_half) const {
    const double fitted = std::min(l.range, 1.01 * farthest_from(l.position));
    const double far = wishes.near_one ? std::max(1.5 * std::min(l.range, fitted), 1.001) : fitted;
    const double near = wishes.near_one ? 1 : kNearShare * far;
    // So much wider that the outermost texels are the filter's.
    const double wide = tan_half * wishes.map_texels / (wishes.map_texels - 2 * kFilterTexels);
    const glm::dmat4 clip = glm::frustum(-wide * near, wide * near, -wide * near, wide * near, near, far);
    const glm::dmat4 to_light = glm::translate(glm::dmat4(1), anchor - l.position);
    return {.light = light,
            .clip_from_anchored = clip * glm::dmat4(view) * to_light,
            .texel = 2 * wide / wishes.map_texels};
  }

  void add_point(int light, const Light& l, std::vector<ShadowMap>& out) const {
    for (int face = 0; face < kCubeFaces; ++face)
      out.push_back(perspective(light, l, view_of_cube_face(face, wishes.up_is_always_y), 1));
  }

  void add_spot(int light, const Light& l, std::vector<ShadowMap>& out) const {
    // Without an edge (lights.spot=cos-power) inner_cos is the cosine's exponent: up to where a thousandth is left.
    const double edge = l.outer_cos > -1 ? l.outer_cos : std::pow(1e-3, 1 / std::max(l.inner_cos, 1e-3));
    const double half = std::min(std::acos(std::clamp(edge, -1.0, 1.0)), kWidestSpot);
    out.push_back(perspective(light, l, view_along(l.direction, some_up(l.direction)), std::tan(half)));
  }

  // Corners of the part of the view between two distances, relative to the camera.
  std::vector<glm::dvec3> view_part(double from, double to) const {
    const ViewRays rays = view_rays(camera, aspect);
    std::vector<glm::dvec3> out;
    for (const double range : {from, to})
      for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0}) {
          const glm::dvec3 across = x * rays.right + y * rays.up;
          out.push_back(camera.orthographic() ? range * rays.forward + across : range * (rays.forward + across));
        }
    return out;
  }

  // Up to where along the view axis there is something to be shadowed. Of stable maps it does not follow the camera's turns, and
  // its steps by steps of an eighth of the scene alone.
  double far_of_scene() const {
    double far = camera.near;
    const auto along = [&](const glm::dvec3& c) {
      return wishes.stable ? glm::distance(c, camera.position) : glm::dot(c - camera.position, camera.forward());
    };
    for (const glm::dvec3& c : corners_of(scene)) far = std::max(far, along(c));
    const double step = wishes.stable ? glm::distance(scene.min, scene.max) / 8 : 0;
    far = step > 0 ? std::ceil(far / step) * step : 1.001 * far;
    return std::max(std::min(far, camera.far), 1.001 * camera.near);
  }

  struct Square {
    glm::dvec2 middle;
    double half;
  };
  // Across the light, about a part of the view.
  Square tight_square(const glm::dmat3& view, const std::vector<glm::dvec3>& corners) const {
    glm::dvec2 low(INFINITY), high(-INFINITY);
    for (const glm::dvec3& c : corners) {
      const glm::dvec2 at(view * (camera.position - anchor + c));
      low = glm::min(low, at), high = glm::max(high, at);
    }
    return {(low + high) / 2.0, std::max(high.x - low.x, high.y - low.y) / 2};
  }
  // About the part's sphere, on the grid of its texels (Valient 2007, "Stable Rendering of Cascaded Shadow Maps").
  Square stable_square(const glm::dmat3& view, const std::vector<glm::dvec3>& corners) const {
    glm::dvec3 middle(0);
    for (const glm::dvec3& c : corners) middle += c / double(corners.size());
    double radius = 0;
    for (const glm::dvec3& c : corners) radius = std::max(radius, glm::distance(c, middle));
    const double half = rounded_up(radius), texel = 2 * half / (wishes.map_texels - 2 * kFilterTexels);
    return {texel * glm::round(glm::dvec2(view * (camera.position - anchor + middle)) / texel), half};
  }

  void add_sun(int light, const Light& l, std::vector<ShadowMap>& out) const {
    const glm::dmat3 view = view_along(l.direction, some_up(l.direction));
    double nearest = -INFINITY, farthest = INFINITY;  // along the light, of all that may hide or be hidden
    for (const glm::dvec3& c : corners_of(scene)) {
      const double z = (view * (c - anchor)).z;
      nearest = std::max(nearest, z), farthest = std::min(farthest, z);
    }
    const double margin = 1e-3 * std::max(nearest - farthest, 1e-9);
    double from = camera.near;
    for (const double to : cascade_ends(camera.near, far_of_scene(), wishes.cascades)) {
      const std::vector<glm::dvec3> corners = view_part(from, to);
      const Square square = wishes.stable ? stable_square(view, corners) : tight_square(view, corners);
      const glm::dvec2 middle = square.middle;
      const double half = square.half * wishes.map_texels / (wishes.map_texels - 2 * kFilterTexels);
      const glm::dmat4 clip = glm::ortho(middle.x - half, middle.x + half, middle.y - half, middle.y + half,
                                         -nearest - margin, -farthest + margin);
      out.push_back({.light = light,
                     .clip_from_anchored = clip * glm::dmat4(view),
                     .texel = 2 * half / wishes.map_texels,
                     .orthographic = true,
                     .up_to = to});
      from = to;
    }
    out.back().up_to = kEndless;
  }

  void add(int light, const Light& l, std::vector<ShadowMap>& out) const {
    switch (l.kind) {
      case LightKind::directional: return add_sun(light, l, out);
      case LightKind::spot: return add_spot(light, l, out);
      case LightKind::point: return add_point(light, l, out);
    }
  }
};

}  // namespace

std::vector<double> cascade_ends(double near, double far, int count) {
  std::vector<double> out;
  for (int k = 1; k <= count; ++k) {
    const double share = double(k) / count;
    out.push_back((near * std::pow(far / near, share) + near + (far - near) * share) / 2);
  }
  return out;
}

glm::dmat3 view_of_cube_face(int face, bool up_is_always_y) {
  glm::dvec3 direction(0);
  direction[face / 2] = face % 2 == 0 ? 1 : -1;
  return view_along(direction, face / 2 == 1 && !up_is_always_y ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0));
}

static void place_tiles(ShadowPlan& plan) {
  const int across = kMostShadowTexels / plan.map_texels, count = static_cast<int>(plan.maps.size());
  const int columns = std::min(count, across);
  for (int k = 0; k < count; ++k)
    plan.maps[static_cast<size_t>(k)].corner = glm::ivec2(k % columns, k / columns) * plan.map_texels;
  plan.size = count == 0 ? glm::ivec2(0) : glm::ivec2(columns, (count + columns - 1) / columns) * plan.map_texels;
}

void keep_only(ShadowPlan& plan, size_t light) {
  const bool has_maps = light < plan.first_map.size() && plan.first_map[light] >= 0;
  std::erase_if(plan.maps, [&](const ShadowMap& m) { return m.light != static_cast<int>(light); });
  for (ShadowMap& m : plan.maps) m.light = 0;
  plan.first_map = {has_maps ? 0 : -1};
  place_tiles(plan);
}

ShadowPlan plan_shadows(std::span<const Light> lights, const Camera& camera, double aspect, const Bounds& scene,
                        const ShadowWishes& wishes) {
  const glm::dvec3 anchor = (scene.min + scene.max) / 2.0;
  const Planner planner{camera, aspect, scene, wishes, anchor};
  ShadowPlan plan{.anchor = anchor, .first_map = std::vector<int>(lights.size(), -1), .map_texels = wishes.map_texels};
  const int across = kMostShadowTexels / wishes.map_texels;
  const auto wants = [&](const Light& l, bool sun) {
    return (l.kind == LightKind::directional) == sun && (sun || (!wishes.suns_only && l.range > 0));
  };
  for (const bool sun : {true, false})
    for (size_t i = 0; i < lights.size(); ++i) {
      if (!wants(lights[i], sun)) continue;
      std::vector<ShadowMap> maps;
      planner.add(static_cast<int>(i), lights[i], maps);
      const size_t room = static_cast<size_t>(across) * static_cast<size_t>(across) - plan.maps.size();
      if (plan.with >= wishes.most_lights || maps.size() > room) {
        ++plan.without;
        continue;
      }
      ++plan.with;
      plan.first_map[i] = static_cast<int>(plan.maps.size());
      plan.maps.insert(plan.maps.end(), maps.begin(), maps.end());
    }
  place_tiles(plan);
  return plan;
}

glm::dmat4 clip_from_relative(const ShadowPlan& plan, const ShadowMap& map, const glm::dvec3& camera) {
  return map.clip_from_anchored * glm::translate(glm::dmat4(1), camera - plan.anchor);
}

bool is_finite(const glm::dmat4& m) {
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j)
      if (!std::isfinite(m[k][j])) return false;
  return true;
}

bool may_hide(const ShadowMap& map, const glm::dvec3& anchor, const Bounds& box) {
  int outside[6] = {};
  for (const glm::dvec3& c : corners_of(box)) {
    const glm::dvec4 clip = map.clip_from_anchored * glm::dvec4(c - anchor, 1);
    for (int k = 0; k < 3; ++k) outside[2 * k] += clip[k]<-clip.w, outside[2 * k + 1] += clip[k]> clip.w;
  }
  return *std::max_element(outside, outside + 6) < 8;  // else all corners lie beyond one side
}

}  // namespace gbl
