// A city at night, in the manner of source 0's first picture (nclgl tutorial 15, "Example G-Buffer output for a
// cityscape"): 12 x 12 blocks 40 apart, houses 10 to 60 high, lamps along the streets, and windows that are flagged as
// unlit: its "fullbright".
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <utility>
#include <vector>

#include "renderer/base/random.h"
#include "renderer/scenes/builtin_scenes.h"
#include "renderer/scenes/scene_parts.h"

namespace gbl {
namespace {

using Profile = std::vector<glm::dvec2>;

constexpr int kBlocks = 12;
constexpr double kPitch = 40, kHalf = kBlocks * kPitch / 2;
constexpr uint64_t kSeed = 1;
constexpr double kStorey = 4;   // height and width of a window's field
constexpr double kParapet = 2;  // above the last storey: heights are 10, 14, ... 58
constexpr double kFacadeUv = 1.0 / 16;
constexpr double kLampHeight = 6.5, kLampRange = 17;

struct HouseShape {
  int storeys, axes;  // windows up and across
  double height() const { return storeys * kStorey + kParapet; }
  double half() const { return axes * kStorey / 2; }
};

struct CityMaterials {
  int ground, roof, iron, windows, lamp;
  std::vector<int> fronts;
};

CityMaterials add_materials(Scene& scene) {
  CityMaterials m{};
  m.ground = add(scene, make_city_ground(512, 1), {.name = "street"});
  const struct {
    const char* name;
    glm::vec4 colour;
  } kFronts[] = {{"sandstone front", {0.9f, 0.8f, 0.64f, 1}},
                 {"brick-red front", {0.66f, 0.36f, 0.28f, 1}},
                 {"grey front", {0.62f, 0.66f, 0.72f, 1}},
                 {"green front", {0.5f, 0.6f, 0.5f, 1}}};
  m.fronts.push_back(add(scene, make_facade(256, 2), {.name = kFronts[0].name, .base_colour = kFronts[0].colour}));
  for (int i = 1; i < 4; ++i) {
    Material front = scene.materials[m.fronts[0]];
    front.name = kFronts[i].name, front.base_colour = kFronts[i].colour;
    m.fronts.push_back(add(scene, front));
  }
  m.roof = add(scene, make_plaster(256, 3), {.name = "roof", .base_colour = {0.3f, 0.3f, 0.32f, 1}});
  m.iron = add(scene, Material{.name = "iron", .base_colour = {0.06f, 0.065f, 0.07f, 1}, .roughness = 0.5f});
  m.windows = add(scene, Material{.name = "lit windows", .unlit = true});
  m.lamp = add(scene, Material{.name = "lamp glass", .base_colour = {1, 0.86f, 0.6f, 1}, .unlit = true});
  return m;
}

// The four sides of a house: where each begins (lower left seen from outside) and where it leads.
template <class F>
void for_each_side(double half, F f) {
  f(glm::dvec3(-half, 0, half), glm::dvec3(1, 0, 0));
  f(glm::dvec3(half, 0, half), glm::dvec3(0, 0, -1));
  f(glm::dvec3(half, 0, -half), glm::dvec3(-1, 0, 0));
  f(glm::dvec3(-half, 0, -half), glm::dvec3(0, 0, 1));
}

Mesh make_fronts(const HouseShape& s) {
  Mesh mesh;
  for_each_side(s.half(), [&](glm::dvec3 corner, glm::dvec3 right) {
    const glm::dvec3 along = right * (2 * s.half()), wall(0, s.storeys * kStorey, 0), parapet(0, kParapet, 0);
    append(mesh, make_sheet(corner, along, wall, kFacadeUv), glm::dmat4(1));
    // The parapet shows the wall below a storey's windows.
    append(mesh, make_sheet(corner + wall, along, parapet, kFacadeUv), glm::dmat4(1), {{0, -0.05 / 16}, {1, 0.35}});
  });
  return mesh;
}

Mesh make_roof(const HouseShape& s, Pcg32& rng) {
  constexpr double kLow = 0.9;  // the roof lies this much below the parapet
  const double top = s.height(), half = s.half(), rim = half - 0.4;
  Mesh mesh;
  append(mesh, make_sheet({-rim, top - kLow, rim}, {2 * rim, 0, 0}, {0, 0, -2 * rim}, 0.2), glm::dmat4(1));
  for_each_side(half, [&](glm::dvec3 corner, glm::dvec3 right) {
    const glm::dvec3 in = glm::cross(glm::dvec3(0, 1, 0), right) * 0.4, up(0, top, 0), along = right * (2 * half);
    append(mesh, make_sheet(corner + up, along, in, 0.2), glm::dmat4(1));                           // on top
    append(mesh, make_sheet(corner + up + in + along, -along, {0, -kLow, 0}, 0.2), glm::dmat4(1));  // inside
  });
  const size_t roof_end = mesh.vertices.size();
  struct Range {
    double low, high;
  };
  const auto box = [&](Range across, Range high) {
    const double h = rng.in(high.low, high.high), d = rng.in(across.low, across.high),
                 w = rng.in(across.low, across.high);
    const double z = rng.in(-rim + d, rim - d), x = rng.in(-rim + w, rim - w);
    const glm::dvec3 at(x, top - kLow, z);
    append(mesh, make_box(at - glm::dvec3(w, 0, d), at + glm::dvec3(w, h, d), 0.2), glm::dmat4(1));
  };
  box({1.5, 2.5}, {2.2, 3.2});
  box({0.7, 1.2}, {1.2, 1.8});
  if (s.storeys > 7) {  // a water tank
    const Profile tank = {{1.6, 0}, {1.6, 2.6}, {1.75, 2.65}, {0, 3.6}};
    const double z = rng.in(-rim, rim) * 0.5, x = rng.in(-rim, rim) * 0.5;
    const glm::dvec3 at(x, top - kLow + 0.6, z);
    append(mesh, make_lathe(tank, 14), glm::translate(glm::dmat4(1), at));
    append(mesh, make_box(at - glm::dvec3(1.1, 0.6, 1.1), at + glm::dvec3(1.1, 0, 1.1), 0.2), glm::dmat4(1));
  }
  for (size_t i = roof_end; i < mesh.vertices.size(); ++i) mesh.vertices[i].colour = {1.9f, 1.8f, 1.7f, 1};  // paler
  return mesh;
}

// A pane before every window where somebody is at home; whole storeys share their light more often than not.
Mesh make_windows(const HouseShape& s, Pcg32& rng) {
  constexpr glm::vec3 kLights[] = {{1, 0.72f, 0.36f}, {1, 0.84f, 0.55f}, {0.92f, 0.9f, 0.8f}, {0.6f, 0.78f, 1}};
  Mesh mesh;
  for (int storey = 0; storey < s.storeys; ++storey) {
    const double share = rng.unit() < 0.25 ? 0.85 : 0.28;
    for_each_side(s.half(), [&](glm::dvec3 corner, glm::dvec3 right) {
      const glm::dvec3 out = glm::cross(right, glm::dvec3(0, 1, 0)) * 0.05;
      for (int axis = 0; axis < s.axes; ++axis) {
        if (rng.unit() > share) continue;
        const glm::dvec3 from = corner + out + right * (axis * kStorey + kWindowLeft + 0.12) +
                                glm::dvec3(0, storey * kStorey + kWindowBottom + 0.12, 0);
        append(mesh,
               make_sheet(from, right * (kWindowRight - kWindowLeft - 0.24), {0, kWindowTop - kWindowBottom - 0.24, 0},
                          0.5),
               glm::dmat4(1));
        const auto strength = static_cast<float>(rng.in(0.35, 1));
        const glm::vec3 light = kLights[rng.next() % 4] * strength;
        for (size_t i = mesh.vertices.size() - 4; i < mesh.vertices.size(); ++i)
          mesh.vertices[i].colour = glm::vec4(light, 1);
      }
    });
  }
  return mesh;
}

struct HouseMeshes {
  int fronts, roof, windows;
};

// Houses of one shape share their meshes; a neighbour's is turned.
void add_houses(Scene& scene, const CityMaterials& m) {
  std::map<std::pair<int, int>, HouseMeshes> built;
  Pcg32 rng(kSeed), details(kSeed + 1);
  for (int row = 0; row < kBlocks; ++row)
    for (int column = 0; column < kBlocks; ++column) {
      // Mostly low, some high: the square of a uniform number.
      const double t = rng.unit();
      const HouseShape shape{2 + static_cast<int>(t * t * 13), 4 + static_cast<int>(rng.next() % 3)};
      const int front = static_cast<int>(rng.next() % 4), turn = static_cast<int>(rng.next() % 4);
      auto found = built.find({shape.storeys, shape.axes});
      if (found == built.end()) {
        const HouseMeshes meshes{add(scene, make_fronts(shape), "fronts"),
                                 add(scene, make_roof(shape, details), "roof"),
                                 add(scene, make_windows(shape, details), "windows")};
        found = built.emplace(std::pair(shape.storeys, shape.axes), meshes).first;
      }
      const glm::dmat4 at = standing_at({(column + 0.5) * kPitch - kHalf, 0, (row + 0.5) * kPitch - kHalf}, turn * 90);
      const std::string which = fmt::format("{}-{}", row + 1, column + 1);
      place(scene, "house " + which, found->second.fronts, m.fronts[static_cast<size_t>(front)], at);
      place(scene, "roof " + which, found->second.roof, m.roof, at);
      place(scene, "windows " + which, found->second.windows, m.windows, at);
    }
}

// A lamp at every crossing and in the middle of every block's side, over the pavement.
void add_street_lamps(Scene& scene, const CityMaterials& m) {
  Mesh post;
  append(post, make_lathe(Profile{{0.16, 0}, {0.14, 0.8}, {0.08, 1}, {0.06, kLampHeight}}, 8), glm::dmat4(1));
  const int iron = add(scene, std::move(post), "lamp-post");
  const int globe = add(scene, make_ellipsoid(glm::dvec3(0.38), 10, 8), "lamp");
  Pcg32 rng(kSeed + 2);
  const auto add_lamp = [&](double x, double z) {
    const std::string which = fmt::format("{}", scene.lights.size() + 1);
    place(scene, "lamp-post " + which, iron, m.iron, standing_at({x, 0, z}));
    place(scene, "lamp " + which, globe, m.lamp, standing_at({x, kLampHeight + 0.3, z}));
    Light light;
    light.position = {x, kLampHeight - 0.2, z};
    light.range = kLampRange;
    light.colour = glm::dvec3(2.1, 1.5, 0.85) * rng.in(0.85, 1.15);
    scene.lights.push_back(light);
  };
  constexpr double kKerb = 6.2;
  for (int i = 0; i <= kBlocks; ++i)
    for (int j = 0; j <= kBlocks; ++j) {
      const double x = i * kPitch - kHalf, z = j * kPitch - kHalf;
      add_lamp(x + kKerb, z + kKerb);
      if (i < kBlocks) add_lamp(x + kPitch * 0.65, z - kKerb);
      if (j < kBlocks) add_lamp(x - kKerb, z + kPitch * 0.65);
    }
}

}  // namespace

Scene build_city() {
  Scene scene;
  scene.name = "city";
  const CityMaterials m = add_materials(scene);
  constexpr double kOutside = kHalf + kPitch;  // a ring of streets and yards around the houses
  place(scene, "ground",
        make_sheet({-kOutside, 0, kOutside}, {2 * kOutside, 0, 0}, {0, 0, -2 * kOutside}, 1 / kPitch, {28, 28}),
        m.ground);
  add_houses(scene, m);
  add_street_lamps(scene, m);
  Light moon;
  moon.kind = LightKind::directional;
  moon.direction = glm::normalize(glm::dvec3(0.55, -0.6, -0.5));
  moon.colour = {0.10, 0.13, 0.2};
  scene.lights.push_back(moon);
  scene.light_box = LightBox{{-kHalf, 3, -kHalf}, {kHalf, 20, kHalf}};
  scene.bounds = bounds_of(scene);
  scene.camera = camera_at({-60, 45, 260}, -20, -12, 60, 1, 2000);
  return scene;
}

}  // namespace gbl
