#include "renderer/gltf/gltf_nodes.h"

#include <cmath>
#include <fmt/format.h>
#include <optional>

#include "renderer/gltf/gltf_limits.h"
#include "renderer/scene/framing.h"

namespace gbl::gltf {
namespace {

bool usable(const glm::dmat4& m) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!(std::abs(m[c][r]) < kMaxCoordinate)) return false;
  // Specification 3.5.3: a transform must not skew w.
  return m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1;
}

std::vector<int> roots_of(const Document& document) {
  if (document.scene >= 0) return document.scenes[static_cast<size_t>(document.scene)];
  std::vector<bool> is_child(document.nodes.size());
  for (const Node& node : document.nodes)
    for (const int child : node.children) is_child[static_cast<size_t>(child)] = true;
  std::vector<int> roots;
  for (size_t i = 0; i < is_child.size(); ++i)
    if (!is_child[i]) roots.push_back(static_cast<int>(i));
  return roots;
}

// Of unit length, or 0 if it has no direction. A length of 1e-200 has one: its square does not.
glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest > 0 ? glm::normalize(v / largest) : glm::dvec3(0);
}

glm::dvec3 across(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 c = glm::cross(unit_or_zero(a), unit_or_zero(b));
  return glm::length(c) > 1e-9 ? glm::normalize(c) : glm::dvec3(0);
}

// A node's own axes, free of scale: cameras and lights have none (specification 3.10, KHR_lights_punctual). A scale of
// 0 hides what the node draws and leaves it its axes, as long as one still says where it looks. None: it looks nowhere.
std::optional<glm::dmat3> axes_of(const glm::dmat4& m) {
  const glm::dvec3 x(m[0]), y(m[1]), z(m[2]), none(0);
  const glm::dvec3 back = z != none ? unit_or_zero(z) : across(x, y);
  if (back == none) return std::nullopt;
  glm::dvec3 right = across(y, back);
  if (right == none) right = across(across(back, x), back);  // x, less what of it looks back
  if (right == none) right = across(std::abs(back.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), back);
  return glm::dmat3(right, glm::cross(back, right), back);
}

double farthest(const Bounds& bounds, const glm::dvec3& from) {
  return glm::distance(bounds.centre(), from) + glm::length(bounds.extent()) / 2;
}

// From the front and above, to the right: glTF's models face +Z (specification 3.4).
Camera overview(const Scene& scene) {
  constexpr double kYaw = 30, kPitch = -20;  // degrees
  constexpr double kFilled = 0.8;            // of the picture's shorter side
  Camera camera;
  camera.orientation = orientation_from_yaw_pitch(kYaw, kPitch);
  return framed(scene, camera, kFilled);
}

}  // namespace

std::vector<PlacedNode> place_nodes(const Document& document, Job& job) {
  std::vector<PlacedNode> placed, stack;
  std::vector<bool> seen(document.nodes.size());
  const auto push = [&](const std::vector<int>& nodes, const glm::dmat4& world_from_parent) {
    for (size_t i = nodes.size(); i-- > 0;) stack.push_back({nodes[i], world_from_parent});  // the first on top
  };
  push(roots_of(document), glm::dmat4(1));
  while (!stack.empty()) {
    PlacedNode next = stack.back();
    stack.pop_back();
    const Node& node = document.nodes[static_cast<size_t>(next.node)];
    if (seen[static_cast<size_t>(next.node)]) {
      job.note(fmt::format("node '{}' hangs in two places or in a circle; taken once", node.name));
      continue;
    }
    seen[static_cast<size_t>(next.node)] = true;
    next.world_from_node = next.world_from_node * node.parent_from_node;
    if (!usable(next.world_from_node)) {
      job.note(fmt::format("node '{}': its transform is no usable matrix; left out with all below it", node.name));
      continue;
    }
    placed.push_back(next);
    push(node.children, next.world_from_node);
  }
  return placed;
}

void add_lights(const Document& document, const std::vector<PlacedNode>& placed, Scene& scene, Job& job) {
  for (const PlacedNode& p : placed) {
    const Node& node = document.nodes[static_cast<size_t>(p.node)];
    if (node.light < 0) continue;
    const LightSource& source = document.lights[static_cast<size_t>(node.light)];
    Light light = source.light;
    light.position = glm::dvec3(p.world_from_node[3]);
    const std::optional<glm::dmat3> axes = axes_of(p.world_from_node);
    if (axes) light.direction = -(*axes)[2];
    const glm::dvec3 c = light.colour;
    const bool sane = c.x >= 0 && c.y >= 0 && c.z >= 0 && std::max({c.x, c.y, c.z}) < kMaxCoordinate;
    const bool aimed = light.kind == LightKind::point || axes;
    if (source.usable && sane && aimed)
      scene.lights.push_back(light);
    else
      job.note(fmt::format("node '{}': its light's kind, colour or direction is not usable; left out", node.name));
  }
}

void set_camera(const Document& document, const std::vector<PlacedNode>& placed, Scene& scene, Job& job) {
  for (const PlacedNode& p : placed) {
    const Node& node = document.nodes[static_cast<size_t>(p.node)];
    if (node.camera < 0) continue;
    const CameraSource& source = document.cameras[static_cast<size_t>(node.camera)];
    const std::optional<glm::dmat3> axes = axes_of(p.world_from_node);
    if (!source.usable || !axes) {
      job.note(fmt::format("node '{}': its camera's lens or direction is not usable; left out", node.name));
      continue;
    }
    scene.camera = source.camera;
    scene.camera.position = glm::dvec3(p.world_from_node[3]);
    scene.camera.orientation = glm::normalize(glm::quat_cast(*axes));
    if (source.endless)
      scene.camera.far = std::max(scene.camera.far, 4 * farthest(scene.bounds, scene.camera.position));
    return;
  }
  scene.camera = overview(scene);
}

}  // namespace gbl::gltf
