#include "renderer/scenes/scene_props.h"

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "renderer/base/random.h"
#include "renderer/scenes/mesh_builder.h"
#include "renderer/scenes/procedural_texture.h"

namespace gbl {
namespace {

using Profile = std::vector<glm::dvec2>;

constexpr double kStoneUvPerUnit = 1.0 / 96;  // the stone texture repeats every 96 units

// A part in one plain colour: its uv shrink into the middle of the swatch.
UvPart painted(Paint paint) {
  constexpr glm::dvec2 kSize(0.04, 0.08);
  return {paint_uv(paint) - kSize / 2.0, kSize};
}

void add_ellipsoid(Mesh& to, glm::dvec3 centre, glm::dvec3 radii, const UvPart& uv, double pitch_deg = 0) {
  const glm::dmat4 place = glm::rotate(glm::translate(glm::dmat4(1), centre), glm::radians(pitch_deg), {0, 0, 1});
  append(to, make_ellipsoid(radii, 10, 7), place, uv);
}

// A round bar from `from` to `to`, closed at both ends.
void add_bar(Mesh& to, glm::dvec3 from, glm::dvec3 end, double radius_from, double radius_end, const UvPart& uv) {
  const double length = glm::distance(from, end);
  const Profile profile = {{0, 0}, {radius_from, 0}, {radius_end, length}, {0, length}};
  append(to, make_lathe(profile, 8), pointing(from, end), uv);
}

void add_torso(Mesh& cow) {
  // From rump to chest; turned so that the profile's axis runs along +X and the seam along the belly.
  const Profile profile = {{0, -28},  {6.5, -27.2}, {10, -24},   {11.6, -18}, {12.2, -8}, {12.4, 0},
                           {11.8, 9}, {11, 14},     {8.5, 18.5}, {4.5, 20.8}, {0, 21.5}};
  const glm::dmat4 flatten = glm::scale(glm::dmat4(1), {1, 1, 0.82});
  const glm::dmat4 lay = glm::rotate(glm::dmat4(1), -glm::half_pi<double>(), {0, 0, 1});
  append(cow, make_lathe(profile, 16), glm::translate(glm::dmat4(1), {0, 33, 0}) * flatten * lay,
         {{0, 0.01}, {1, 0.7}});
  add_ellipsoid(cow, {-19, 37, 0}, {8, 8, 9}, painted(Paint::white));     // hips
  add_ellipsoid(cow, {13, 36.5, 0}, {7, 9, 8.6}, painted(Paint::black));  // shoulders
}

void add_legs(Mesh& cow) {
  const Profile shank = {{2.1, 3}, {1.7, 9}, {2.2, 13.5}, {3.0, 18}, {4.4, 27}, {0, 29}};
  const Profile hoof = {{0, 0}, {2.7, 0}, {2.2, 3.4}, {0, 3.4}};
  for (double x : {-20.5, 13.5})
    for (double z : {-5.6, 5.6}) {
      const glm::dmat4 place = glm::translate(glm::dmat4(1), {x, 0, z});
      append(cow, make_lathe(shank, 10), place, painted(Paint::white));
      append(cow, make_lathe(hoof, 10), place, painted(Paint::hoof));
      add_ellipsoid(cow, {x, 27, z * 0.85}, {5.6, 9, 4.2}, painted(Paint::white));  // thigh
    }
}

void add_head(Mesh& cow) {
  append(cow, make_lathe(Profile{{0, 0}, {8.6, 1}, {7.2, 9}, {5.4, 17}, {0, 19}}, 12),
         pointing({13, 36, 0}, {31, 45, 0}), painted(Paint::black));
  add_ellipsoid(cow, {33, 45.5, 0}, {6, 5.6, 4.9}, painted(Paint::black));
  append(cow, make_lathe(Profile{{0, 0}, {4.9, 0.8}, {3.6, 8}, {3.4, 10}, {0, 10.6}}, 12),
         pointing({34.5, 44.5, 0}, {43.5, 39.2, 0}), painted(Paint::white));
  add_ellipsoid(cow, {43.6, 39, 0}, {3.2, 3.5, 4.1}, painted(Paint::pink), -30);
  for (double side : {-1.0, 1.0}) {
    const auto at = [side](double x, double y, double z) { return glm::dvec3(x, y, z * side); };
    add_ellipsoid(cow, at(37.5, 45.5, 3.9), glm::dvec3(1.1), painted(Paint::hoof));
    add_ellipsoid(cow, at(45.6, 40, 1.7), glm::dvec3(0.9), painted(Paint::hoof));  // nostrils
    add_ellipsoid(cow, at(31.5, 46.5, 7.6), {1.3, 1.9, 4.2}, painted(Paint::black));
    add_bar(cow, at(32, 49.5, 2.6), at(32.5, 53, 6.6), 1.4, 1.1, painted(Paint::horn));
    add_bar(cow, at(32.5, 52.8, 6.5), at(34.5, 57.5, 7.6), 1.1, 0.2, painted(Paint::horn));
  }
}

void add_rear(Mesh& cow) {
  add_ellipsoid(cow, {-12, 22.5, 0}, {6.2, 4.6, 5.2}, painted(Paint::pink));  // udder
  for (double x : {-14.5, -9.5})
    for (double z : {-2.4, 2.4}) add_bar(cow, {x, 20.5, z}, {x, 16.4, z}, 1, 0.7, painted(Paint::pink));
  add_bar(cow, {-26, 40, 0}, {-29.5, 35, 0}, 1.5, 1.2, painted(Paint::white));
  add_bar(cow, {-29.4, 35.4, 0}, {-30, 19, 0}, 1.2, 0.9, painted(Paint::white));
  add_ellipsoid(cow, {-30, 16, 0}, {1.9, 4.4, 1.9}, painted(Paint::black));  // tuft
}

// A joint between two stones of the arch: the points where it meets the opening and the outside.
struct Joint {
  glm::dvec2 inner, outer;
};

std::vector<Joint> arch_joints() {
  constexpr double kInner = 50, kOuter = 85,
                   kSpring = 65;                // spring: where the legs end and the half circle begins
  constexpr double kLeg[] = {-14, 12, 34, 56};  // from below the ground up
  constexpr int kStones = 11;                   // odd: a keystone in the middle
  std::vector<Joint> joints;
  for (double y : kLeg) joints.push_back({{kInner, y}, {kOuter, y}});
  for (int i = 0; i <= kStones; ++i) {
    const double angle = glm::pi<double>() * i / kStones;
    const glm::dvec2 direction(std::cos(angle), std::sin(angle)), centre(0, kSpring);
    joints.push_back({centre + direction * kInner, centre + direction * kOuter});
  }
  for (int i = 3; i >= 0; --i) joints.push_back({{-kInner, kLeg[i]}, {-kOuter, kLeg[i]}});
  return joints;
}

}  // namespace

Mesh make_cow() {
  Mesh cow;
  cow.name = "cow";
  add_torso(cow);
  add_legs(cow);
  add_head(cow);
  add_rear(cow);
  return cow;
}

Mesh make_lamp_post() {
  Mesh lamp;
  lamp.name = "lamp-post";
  const auto add = [&lamp](const Profile& profile, int sides, Paint paint) {
    append(lamp, make_lathe(profile, sides), glm::dmat4(1), painted(paint));
  };
  add({{0, -8}, {7, -8}, {7, 3}, {5, 6}, {4, 9}, {2.4, 13}, {2, 60}, {1.7, 104}, {0, 104}}, 12, Paint::iron);
  add({{0, 34}, {3, 34}, {3, 36.5}, {0, 36.5}}, 12, Paint::brass);
  add({{0, 100}, {3, 101}, {5.5, 106}, {5.5, 107.5}, {0, 107.5}}, 6, Paint::iron);
  add({{0, 107}, {4.6, 107}, {7.4, 119}, {0, 119}}, 6, Paint::glass);
  add({{0, 118.5}, {9.6, 118.5}, {8.6, 120.5}, {3, 126}, {0, 126}}, 6, Paint::iron);
  add({{0, 125}, {1.5, 126}, {1.9, 127.6}, {1.3, 129.2}, {0, 130}}, 8, Paint::brass);
  for (int i = 0; i < 6; ++i) {  // ribs along the edges of the glass
    const double angle = glm::two_pi<double>() * i / 6;
    const glm::dvec3 out(std::cos(angle), 0, std::sin(angle));
    add_bar(lamp, out * 4.7 + glm::dvec3(0, 107, 0), out * 7.5 + glm::dvec3(0, 119, 0), 0.6, 0.6, painted(Paint::iron));
  }
  add_bar(lamp, {-9, 96, 0}, {9, 96, 0}, 0.9, 0.9, painted(Paint::iron));  // the ladder's rest
  return lamp;
}

Mesh make_arch() {
  constexpr double kHalfDepth = 19;
  Mesh arch;
  arch.name = "arch";
  const std::vector<Joint> joints = arch_joints();
  Pcg32 rng(7);  // each stone shows another part of the texture
  for (size_t i = 0; i + 1 < joints.size(); ++i) {
    const Joint &a = joints[i], &b = joints[i + 1];
    const double proud = i % 2 ? 1 : 0;  // every other stone stands out, so that the joints have edges
    std::array<glm::dvec3, 8> corners;
    for (int k = 0; k < 8; ++k) {
      const Joint& joint = k & 2 ? b : a;
      const glm::dvec2 outward = glm::normalize(joint.outer - joint.inner);
      corners[k] = glm::dvec3(k & 1 ? joint.outer + outward * proud - outward : joint.inner - outward * proud,
                              (k & 4 ? 1 : -1) * (kHalfDepth + proud));
    }
    append(arch, make_hexahedron(corners, kStoneUvPerUnit, {rng.unit(), rng.unit()}), glm::dmat4(1));
  }
  return arch;
}

Mesh make_wall() {
  constexpr double kCourse = 13, kHalfWidth = 8;
  Mesh wall;
  wall.name = "wall";
  Pcg32 rng(11);
  for (int leg = 0; leg < 2; ++leg) {
    const double length = leg == 0 ? 120 : 90;
    for (int course = 0; course < 3; ++course) {
      double from = course % 2 ? -kHalfWidth : kHalfWidth;  // corner stones alternate between the legs
      if (leg == 1) from = -from;
      const double end = length - 14.0 * course;  // the ends step down
      while (from < end) {
        const double wanted = from + rng.in(20, 32), proud = rng.in(-0.8, 0.8);
        const double to = wanted > end - 10 ? end : wanted;  // no slivers
        const double bottom = course == 0 ? -8 : kCourse * course;
        const glm::dvec3 low(-to + 0.3, bottom, -kHalfWidth - proud);
        const glm::dvec3 high(-from - 0.3, kCourse * (course + 1) - 0.2, kHalfWidth + proud);
        const Mesh stone = make_box(low, high, kStoneUvPerUnit, {rng.unit(), rng.unit()});
        append(wall, stone, glm::rotate(glm::dmat4(1), leg * -glm::half_pi<double>(), {0, 1, 0}));
        from = to;
      }
    }
  }
  return wall;
}

}  // namespace gbl
