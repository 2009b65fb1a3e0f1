#include "renderer/scenes/scene_house.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "renderer/scenes/mesh_builder.h"
#include "renderer/scenes/scene_parts.h"

namespace gbl {
namespace {

constexpr double kHalfWidth = 2.6, kHalfDepth = 2, kWall = 2.6, kRidge = 4.3;
constexpr double kBrickUv = 1.3, kRoofUv = 0.5, kWoodUv = 0.5;

void add_box(Mesh& to, glm::dvec3 low, glm::dvec3 high, double uv) {
  append(to, make_box(low, high, uv, {low.x * uv, -low.y * uv}), glm::dmat4(1));
}

// A flat triangle, counter-clockwise seen from outside; u runs along its first side.
void add_gable(Mesh& to, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  const glm::dvec3 along = glm::normalize(b - a), normal = glm::normalize(glm::cross(b - a, c - a));
  const glm::dvec3 up = glm::cross(normal, along);
  Mesh part;
  for (const glm::dvec3& p : {a, b, c})
    part.vertices.push_back({.position = p,
                             .normal = normal,
                             .tangent = glm::dvec4(along, 1),
                             .uv = glm::dvec2(glm::dot(p - a, along), -glm::dot(p, up)) * kBrickUv});
  part.indices = {0, 1, 2};
  append(to, part, glm::dmat4(1));
}

void add_walls(House& house) {
  add_box(house.walls, {-kHalfWidth, -0.3, -kHalfDepth}, {kHalfWidth, kWall, kHalfDepth}, kBrickUv);
  for (double side : {-1.0, 1.0}) {
    const double x = side * kHalfWidth;
    add_gable(house.walls, {x, kWall, side * kHalfDepth}, {x, kWall, -side * kHalfDepth}, {x, kRidge, 0});
  }
  add_box(house.walls, {1.2, 2.8, -1.25}, {1.85, 4.75, -0.65}, kBrickUv);  // chimney
  add_box(house.walls, {1.13, 4.75, -1.32}, {1.92, 4.9, -0.58}, kBrickUv);
}

// One slope; the other is the same turned round, so that the tiles lap downwards on both.
Mesh make_slope() {
  constexpr double kOver = 0.35, kThick = 0.12;
  const double fall = (kRidge - kWall) / kHalfDepth;
  const double eaves_z = kHalfDepth + kOver, eaves_y = kWall - fall * kOver;
  std::array<glm::dvec3, 8> corners;
  for (int i = 0; i < 8; ++i) {
    const double x = (i & 1 ? 1 : -1) * (kHalfWidth + kOver);
    const glm::dvec2 edge = i & 4 ? glm::dvec2(eaves_y, eaves_z) : glm::dvec2(kRidge, 0);
    corners[i] = {x, edge.x + (i & 2 ? kThick : 0.0) + 0.02, edge.y};
  }
  return make_hexahedron(corners, kRoofUv);
}

void add_roof(House& house) {
  const Mesh slope = make_slope();
  append(house.roof, slope, glm::dmat4(1));
  append(house.roof, slope, glm::rotate(glm::dmat4(1), glm::pi<double>(), {0, 1, 0}));
  add_box(house.roof, {-kHalfWidth - 0.36, kRidge + 0.06, -0.12}, {kHalfWidth + 0.36, kRidge + 0.2, 0.12}, kRoofUv);
}

// A window or a door's frame on the wall that faces +Z.
void add_window(House& house, double x, double bottom, double width, double height, double z) {
  const double left = x - width / 2, right = x + width / 2, top = bottom + height, bar = 0.07;
  const auto wood = [&](double x0, double y0, double x1, double y1, double out) {
    append(house.wood, make_rounded_box({x0, y0, z - 0.02}, {x1, y1, z + out}, 0.015, 1, kWoodUv), glm::dmat4(1));
  };
  wood(left - bar, bottom, left, top, 0.06);
  wood(right, bottom, right + bar, top, 0.06);
  wood(left - bar, top, right + bar, top + bar, 0.06);
  wood(left - 0.14, bottom - bar, right + 0.14, bottom, 0.12);  // sill
  wood(x - 0.02, bottom, x + 0.02, top, 0.04);
  wood(left, bottom + height * 0.6, right, bottom + height * 0.6 + 0.04, 0.04);
  append(house.panes, make_sheet({left, bottom, z + 0.015}, {width, 0, 0}, {0, height, 0}, 1), glm::dmat4(1));
}

void add_door(House& house) {
  constexpr double kX = 0.25, kHalf = 0.5, kTop = 2.05, kZ = kHalfDepth;
  const auto wood = [&house](glm::dvec3 low, glm::dvec3 high) {
    append(house.wood, make_rounded_box(low, high, 0.015, 1, kWoodUv), glm::dmat4(1));
  };
  for (int board = 0; board < 5; ++board)
    wood({kX - kHalf + 0.2 * board, 0.05, kZ - 0.02}, {kX - kHalf + 0.2 * board + 0.195, kTop, kZ + 0.04});
  wood({kX - kHalf - 0.1, 0, kZ - 0.02}, {kX - kHalf, kTop + 0.1, kZ + 0.09});
  wood({kX + kHalf, 0, kZ - 0.02}, {kX + kHalf + 0.1, kTop + 0.1, kZ + 0.09});
  wood({kX - kHalf, kTop, kZ - 0.02}, {kX + kHalf, kTop + 0.1, kZ + 0.09});
  wood({kX - kHalf, 0.4, kZ + 0.03}, {kX + kHalf, 0.52, kZ + 0.06});
  wood({kX - kHalf, 1.5, kZ + 0.03}, {kX + kHalf, 1.62, kZ + 0.06});
  add_box(house.walls, {kX - 0.75, -0.3, kZ}, {kX + 0.75, 0.05, kZ + 0.55}, kBrickUv);  // step
}

}  // namespace

House make_house() {
  House house;
  add_walls(house);
  add_roof(house);
  add_window(house, -1.45, 1, 1, 1.05, kHalfDepth);
  add_window(house, 1.7, 1, 0.8, 1.05, kHalfDepth);
  Mesh front_wood = std::move(house.wood), front_panes = std::move(house.panes);
  house.wood = {}, house.panes = {};
  add_window(house, 0, 1, 1, 1.05, kHalfWidth);  // of a gable: built facing +Z, turned to +X and -X
  for (double turn : {0.5, -0.5}) {
    const glm::dmat4 to_side = glm::rotate(glm::dmat4(1), turn * glm::pi<double>(), {0, 1, 0});
    append(front_wood, house.wood, to_side);
    append(front_panes, house.panes, to_side);
  }
  house.wood = std::move(front_wood), house.panes = std::move(front_panes);
  add_door(house);
  return house;
}

}  // namespace gbl
