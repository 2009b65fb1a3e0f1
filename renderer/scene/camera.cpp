#include "renderer/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace gbl {

double Camera::half_height(double picture_aspect) const {
  const double asked = orthographic() ? orthographic_height / 2 : std::tan(glm::radians(fov) / 2);
  return asked * std::max(1.0, aspect / picture_aspect);
}

glm::dquat orientation_from_yaw_pitch(double yaw_deg, double pitch_deg) {
  return glm::angleAxis(glm::radians(yaw_deg), glm::dvec3(0, 1, 0)) *
         glm::angleAxis(glm::radians(pitch_deg), glm::dvec3(1, 0, 0));
}

glm::dvec2 yaw_pitch_of(const glm::dquat& q) {
  const glm::dvec3 f = q * glm::dvec3(0, 0, -1);
  const double pitch = std::asin(std::clamp(f.y, -1.0, 1.0));
  // Looking straight up or down the forward axis has no heading: take it from the camera's right axis.
  const glm::dvec3 r = q * glm::dvec3(1, 0, 0);
  const double yaw = std::abs(f.y) < 1 - 1e-12 ? std::atan2(-f.x, -f.z) : std::atan2(-r.z, r.x);
  return {glm::degrees(yaw), glm::degrees(pitch)};
}

glm::dmat4 clip_from_view(const Camera& c, double aspect, DepthRuns runs) {
  const double h = c.half_height(aspect), n = c.near;
  glm::dmat4 clip = c.orthographic() ? glm::ortho(-h * aspect, h * aspect, -h, h, n, c.far)
                                     : glm::frustum(-h * aspect * n, h * aspect * n, -h * n, h * n, n, c.far);
  if (runs == DepthRuns::reversed) {
    clip[2][2] = (c.orthographic() ? 1 : c.near) / (c.far - c.near);
    clip[3][2] = c.far * clip[2][2];
  }
  return clip;
}

glm::dmat4 clip_from_relative(const Camera& c, double aspect, DepthRuns runs) {
  return clip_from_view(c, aspect, runs) * glm::mat4_cast(glm::conjugate(c.orientation));
}

ViewRays view_rays(const Camera& c, double aspect) {
  const double half_height = c.half_height(aspect);
  return {c.forward(), c.right() * half_height * aspect, c.up() * half_height};
}

double range_from_depth(const Camera& c, double depth, DepthRuns runs) {
  const double from_far = runs == DepthRuns::reversed ? depth : 1 - depth;
  if (c.orthographic()) return c.far - from_far * (c.far - c.near);
  // near far / (far - depth (far - near)), without its cancellation: 1 - depth is exact from 0.5 on.
  return c.near * c.far / (c.near + from_far * (c.far - c.near));
}

double depth_from_range(const Camera& c, double range, DepthRuns runs) {
  const double part = c.orthographic() ? 1 : runs == DepthRuns::reversed ? c.near / range : c.far / range;
  return part * (runs == DepthRuns::reversed ? c.far - range : range - c.near) / (c.far - c.near);
}

double near_corner_factor(const Camera& c, double aspect) {
  if (c.orthographic()) {  // the corner's distance does not scale with near: give it as a factor all the same
    const double h = c.half_height(aspect);
    return std::sqrt(c.near * c.near + h * h * (1 + aspect * aspect)) / c.near;
  }
  const double t = c.half_height(aspect);
  return std::sqrt(1 + t * t * (1 + aspect * aspect));
}

}  // namespace gbl
