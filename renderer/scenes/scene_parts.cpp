#include "renderer/scenes/scene_parts.h"

#include <array>
#include <cassert>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>
#include <vector>

namespace gbl {
namespace {

// Where the lines of a rounded face run, from -half to half: `steps` per bend at equal angles as seen from the bend's
// centre, then straight across.
std::vector<double> face_lines(double half, double radius, int steps) {
  std::vector<double> lines;
  for (int i = 0; i <= steps; ++i)
    lines.push_back(-half + radius * (1 - std::tan(glm::quarter_pi<double>() * (steps - i) / steps)));
  for (int i = steps; i >= 0; --i) {
    if (-lines[i] > lines.back() + 1e-9) lines.push_back(-lines[i]);
  }
  return lines;
}

// Axes of a face seen from outside: right, up, outward.
constexpr std::array<glm::dvec3, 3> kFaces[6] = {
    {{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}}, {{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}}, {{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}},
    {{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},  {{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}},
};

void add_grid(Mesh& mesh, uint32_t first, uint32_t columns, uint32_t rows) {  // rows from the lowest up
  for (uint32_t j = 0; j + 1 < rows; ++j)
    for (uint32_t i = 0; i + 1 < columns; ++i) {
      const uint32_t a = first + j * columns + i, b = a + 1, c = a + columns, d = c + 1;
      mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
    }
}

}  // namespace

int add(Scene& scene, Texture texture) {
  scene.textures.push_back(std::move(texture));
  return static_cast<int>(scene.textures.size()) - 1;
}

int add(Scene& scene, Material material) {
  scene.materials.push_back(std::move(material));
  return static_cast<int>(scene.materials.size()) - 1;
}

int add(Scene& scene, Mesh mesh, const char* name) {
  mesh.name = name;
  scene.meshes.push_back(std::move(mesh));
  return static_cast<int>(scene.meshes.size()) - 1;
}

int add(Scene& scene, SurfaceTextures textures, Material m) {
  m.base_colour_texture = {add(scene, std::move(textures.albedo))};
  m.normal_texture = {add(scene, std::move(textures.normal))};
  m.roughness_texture = {add(scene, std::move(textures.roughness))};
  return add(scene, std::move(m));
}

int add_relief(Scene& scene, SurfaceTextures textures, Material m, double uv_per_unit, double deeper) {
  m.height_texture = {add(scene, std::move(textures.height))};
  m.height_depth = static_cast<float>(deeper * textures.depth / uv_per_unit);
  return add(scene, std::move(textures), std::move(m));
}

void place(Scene& scene, std::string name, int mesh, int material, const glm::dmat4& world_from_object) {
  scene.instances.push_back({std::move(name), mesh, material, world_from_object});
}

void place(Scene& scene, const char* name, Mesh mesh, int material) {
  place(scene, name, add(scene, std::move(mesh), name), material);
}

glm::dmat4 standing_at(glm::dvec3 place, double yaw_deg, double scale) {
  const glm::dmat4 moved = glm::translate(glm::dmat4(1), place);
  return glm::scale(glm::rotate(moved, glm::radians(yaw_deg), {0, 1, 0}), glm::dvec3(scale));
}

Camera camera_at(glm::dvec3 position, double yaw_deg, double pitch_deg, double fov, double near, double far) {
  Camera camera;
  camera.position = position;
  camera.orientation = orientation_from_yaw_pitch(yaw_deg, pitch_deg);
  camera.fov = fov;
  camera.near = near;
  camera.far = far;
  return camera;
}

Mesh make_sheet(glm::dvec3 corner, glm::dvec3 right, glm::dvec3 up, double uv_per_unit, glm::ivec2 cells) {
  const glm::dvec3 along = glm::normalize(right);
  const glm::dvec3 normal = glm::normalize(glm::cross(right, up));
  const glm::dvec3 upward = glm::cross(normal, along);
  Mesh mesh;
  for (int j = 0; j <= cells.y; ++j)
    for (int i = 0; i <= cells.x; ++i) {
      const glm::dvec3 p = right * (static_cast<double>(i) / cells.x) + up * (static_cast<double>(j) / cells.y);
      mesh.vertices.push_back({.position = corner + p,
                               .normal = normal,
                               .tangent = glm::dvec4(along, 1),
                               .uv = glm::dvec2(glm::dot(p, along), -glm::dot(p, upward)) * uv_per_unit});
    }
  add_grid(mesh, 0, static_cast<uint32_t>(cells.x) + 1, static_cast<uint32_t>(cells.y) + 1);
  return mesh;
}

Mesh make_rounded_box(glm::dvec3 low, glm::dvec3 high, double radius, int steps, double uv_per_unit,
                      glm::dvec2 uv_start) {
  const glm::dvec3 centre = (low + high) * 0.5, half = (high - low) * 0.5, inner = half - radius;
  assert(radius > 0 && inner.x >= 0 && inner.y >= 0 && inner.z >= 0);
  Mesh mesh;
  for (const auto& [right, up, out] : kFaces) {
    const auto extent = [&half](glm::dvec3 axis) { return glm::dot(glm::abs(axis), half); };
    const std::vector<double> across = face_lines(extent(right), radius, steps);
    const std::vector<double> upward = face_lines(extent(up), radius, steps);
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    for (double y : upward)
      for (double x : across) {
        const glm::dvec3 on_box = right * x + up * y + out * extent(out);
        const glm::dvec3 core = glm::clamp(on_box, -inner, inner);
        const glm::dvec3 normal = glm::normalize(on_box - core);
        const glm::dvec2 uv = glm::dvec2(x + extent(right), extent(up) - y) * uv_per_unit + uv_start;
        mesh.vertices.push_back(
            {.position = centre + core + normal * radius, .normal = normal, .tangent = {}, .uv = uv});
      }
    add_grid(mesh, first, static_cast<uint32_t>(across.size()), static_cast<uint32_t>(upward.size()));
  }
  set_tangents(mesh);
  return mesh;
}

Mesh make_tube(std::span<const glm::dvec3> points, double radius, int sides) {
  assert(points.size() >= 2 && sides >= 3);
  double length = 0, done = 0;
  for (size_t k = 1; k < points.size(); ++k) length += glm::distance(points[k - 1], points[k]);
  Mesh mesh;
  glm::dvec3 x;  // carried along the tube, so that it does not twist
  for (size_t k = 0; k < points.size(); ++k) {
    const glm::dvec3 before = points[k > 0 ? k - 1 : 0], after = points[std::min(k + 1, points.size() - 1)];
    const glm::dvec3 along = glm::normalize(after - before);
    if (k == 0) x = glm::dvec3(pointing(before, after)[0]);
    x = glm::normalize(x - along * glm::dot(x, along));
    const glm::dvec3 z = glm::cross(x, along);
    if (k > 0) done += glm::distance(points[k - 1], points[k]);
    for (int j = 0; j <= sides; ++j) {
      const double angle = glm::two_pi<double>() * (j % sides) / sides;
      const glm::dvec3 out = x * std::cos(angle) - z * std::sin(angle);
      mesh.vertices.push_back({.position = points[k] + out * radius,
                               .normal = out,
                               .tangent = {},
                               .uv = glm::dvec2(static_cast<double>(j) / sides, 1 - done / length)});
    }
  }
  add_grid(mesh, 0, static_cast<uint32_t>(sides) + 1, static_cast<uint32_t>(points.size()));
  set_tangents(mesh);
  return mesh;
}

Mesh make_ground(const std::vector<double>& x, const std::vector<double>& z,
                 const std::function<double(double x, double z)>& height, double uv_per_unit) {
  Mesh mesh;
  const auto around = [](const std::vector<double>& lines, size_t i) {  // the neighbouring lines
    return glm::dvec2(lines[i > 0 ? i - 1 : 0], lines[std::min(i + 1, lines.size() - 1)]);
  };
  for (size_t j = 0; j < z.size(); ++j)
    for (size_t i = 0; i < x.size(); ++i) {
      const glm::dvec2 px = around(x, i), pz = around(z, j);
      const double along_x = (height(px.y, z[j]) - height(px.x, z[j])) / (px.y - px.x);
      const double along_z = (height(x[i], pz.y) - height(x[i], pz.x)) / (pz.y - pz.x);
      const glm::dvec3 n = glm::normalize(glm::dvec3(-along_x, 1, -along_z));
      mesh.vertices.push_back({.position = glm::dvec3(x[i], height(x[i], z[j]), z[j]),
                               .normal = n,
                               .tangent = glm::dvec4(glm::normalize(glm::dvec3(n.y, -n.x, 0)), 1),
                               .uv = glm::dvec2(x[i], z[j]) * uv_per_unit});
    }
  const auto columns = static_cast<uint32_t>(x.size()), rows = static_cast<uint32_t>(z.size());
  for (uint32_t j = 0; j + 1 < rows; ++j)
    for (uint32_t i = 0; i + 1 < columns; ++i) {
      const uint32_t a = j * columns + i, b = a + 1, c = a + columns, d = c + 1;
      mesh.indices.insert(mesh.indices.end(), {a, c, b, b, c, d});
    }
  return mesh;
}

Mesh retiled(const Mesh& mesh, glm::dvec2 times) {
  Mesh out;
  append(out, mesh, glm::dmat4(1), {{0, 0}, times});
  return out;
}

}  // namespace gbl
