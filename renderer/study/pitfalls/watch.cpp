#include "renderer/study/pitfalls/watch.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/light/light_volume.h"
#include "renderer/options/options.h"

namespace gbl {
namespace {

// One light as its volume is drawn.
struct WatchedLight {
  double distance, along;  // from the camera to its centre: straight, and along the view axis
  double range, reach;     // of the light, and of its mesh
  Faces faces;
};

// Only the words: which light it is stands before them.
std::optional<Watched> watched_volume(const Settings& s, const WatchedLight& l, double corner) {
  const bool clipped = s.lights.volume.clip == VolumeClip::planes;
  switch (l.faces) {
    case Faces::front:
      if (l.distance < l.range)
        return Watched{"backface-cull-inside", "the camera is inside, and front faces are drawn"};
      if (l.distance < l.reach)
        return Watched{"circumscribe-without-inside-test", "the camera is inside its mesh, and front faces are drawn"};
      if (clipped && l.distance < l.reach + corner) return Watched{"near-plane-cut", "the near plane cuts it"};
      break;
    case Faces::both:
      if (l.distance > l.reach + corner) return Watched{"no-culling-doubles", "both faces are drawn: it counts twice"};
      break;
    case Faces::back: break;
  }
  if (clipped && l.faces == Faces::back && l.along + l.reach > s.camera.far && l.along - l.range < s.camera.far)
    return Watched{"far-plane-clips-backfaces", "the far plane cuts its back faces"};
  return {};
}

std::optional<Watched> watched_disc(const WatchedLight& l) {
  if (l.along < 0) return Watched{"circle-behind-camera", "it stands behind the camera: its disc is mirrored"};
  if (l.distance < 1.5 * l.range) return Watched{"flat-circle-undercovers", "it is so near that its disc is too small"};
  return {};
}

std::optional<Watched> watched_lights(const Settings& s, std::span<const Light> lights, double aspect) {
  const bool disc = s.lights.method == LightMethod::disc, volumes = in_use(option("lights.cull"), s);
  if (!disc && !volumes) return {};
  const double corner = s.camera.near * near_corner_factor(s.camera, aspect);
  const CullRule rule = cull_rule(s.lights.cull, corner);
  for (size_t i = 0; i < lights.size(); ++i) {
    const Light& light = lights[i];
    if (volume_shape(light) != VolumeShape::sphere) continue;
    const glm::dvec3 relative = light.position - s.camera.position;
    const double scale = volume_scale(s.lights.volume.fit, s.lights.volume.level, VolumeShape::sphere);
    WatchedLight l{
        glm::length(relative), glm::dot(relative, s.camera.forward()), light.range, volume_reach(light, scale, 0), {}};
    if (l.along < -l.reach) continue;  // behind the camera: nothing of it can be seen
    l.faces = faces_to_draw(rule, l.distance, l.range, l.reach);
    std::optional<Watched> found = disc ? watched_disc(l) : watched_volume(s, l, corner);
    if (!found) continue;
    const size_t number = s.lights.only >= 0 ? static_cast<size_t>(s.lights.only) : i;
    found->sentence = fmt::format("light {}: {}", number, found->sentence);
    return found;
  }
  return {};
}

// Half floats have 11 bits: a coordinate between two powers of 2 has a thousand steps.
std::optional<Watched> watched_positions(const Settings& s) {
  const glm::dvec3 p = glm::abs(s.camera.position);
  const double step = std::exp2(std::floor(std::log2(std::max({p.x, p.y, p.z, 1e-9}))) - 10);
  if (s.position.source != PositionSource::world16f || !in_use(option("position.source"), s) || step < 0.1) return {};
  return Watched{"fp16-world-position",
                 fmt::format("this far from the origin positions have steps of {:.2g} units", step)};
}

}  // namespace

std::optional<Watched> watched(const Settings& s, std::span<const Light> lights, double aspect) {
  std::optional<Watched> found = watched_lights(s, lights, aspect);
  return found ? found : watched_positions(s);
}

}  // namespace gbl
