// The reference against scenes whose answer is known in closed form. 1e-9 relative: double's own rounding through a
// ray, a matrix and a few roots stays below 1e-12; a wrong formula does not.
#include "renderer/truth/reference.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include "tests/test_support.h"
#include "tests/truth/closed_scene.h"

namespace gbl::test {
namespace {

constexpr double kClosedForm = 1e-9;

// Calls check(world point, index) for every pixel that sees a surface, and demands that there are some.
template <class Check>
void each_surface(const Truth& truth, const Settings& s, Check check) {
  size_t seen = 0;
  for (size_t i = 0; i < truth.pixels(); ++i) {
    if (!truth.present[i]) continue;
    ++seen;
    check(truth.position[i] + s.camera.position, i);
  }
  EXPECT_GT(seen, truth.pixels() / 4);
}

void expect_close(double got, double expected, size_t pixel) {
  EXPECT_LE(relative_error(got, expected), kClosedForm) << "pixel " << pixel << ": " << got << " for " << expected;
}

TEST(Reference, PointsOfALevelPlaneAreWhereTheRaysMeetIt) {
  const Settings s = closed_settings();
  const Truth truth = truth_of(make_plane(20), s);
  for (int y = 0; y < s.size.y; ++y)
    for (int x = 0; x < s.size.x; ++x) {
      const size_t i = static_cast<size_t>(y * s.size.x + x);
      if (!truth.present[i]) continue;
      const double tan_half = std::tan(glm::radians(s.camera.fov / 2));
      const glm::dvec3 in_view(((x + 0.5) / s.size.x * 2 - 1) * tan_half * s.size.x / s.size.y,
                               (1 - (y + 0.5) / s.size.y * 2) * tan_half, -1);
      const glm::dvec3 direction = s.camera.orientation * in_view;
      const glm::dvec3 expected = direction * (-s.camera.position.y / direction.y);
      EXPECT_LE(glm::distance(truth.position[i], expected), kClosedForm * glm::length(expected));
      EXPECT_LE(glm::distance(truth.normal[i], glm::dvec3(0, 1, 0)), kClosedForm);
    }
}

TEST(Reference, OneLightAboveAWhitePlane) {
  Scene scene = make_plane(20);
  const glm::dvec3 colour(1, 0.5, 0.25), at(0.5, 2.5, -1);
  scene.lights = {point_light(at, kEndless, colour)};
  const Settings s = closed_settings();
  const Truth truth = truth_of(scene, s);
  each_surface(truth, s, [&](glm::dvec3 p, size_t i) {
    const double cosine = at.y / glm::distance(p, at);
    for (int k = 0; k < 3; ++k) expect_close(truth.lit[i][k], colour[k] * cosine, i);
  });
}

TEST(Reference, EveryFalloffFollowsItsFormula) {
  const double r = 9;
  const auto expected = [&](Attenuation a, double d) {
    switch (a) {
      case Attenuation::none: return 1.0;
      case Attenuation::linear: return 1 - d / r;
      case Attenuation::quadratic: return 1 / (1 + 0.7 * d + 1.8 * d * d);
      case Attenuation::ramp: return 1 / std::max(1.0, 0.2 + 1.6 * d / r + 6.4 * d * d / (r * r));
      case Attenuation::inverse_linear: return 1 / (1 + 9 * d / r);
      case Attenuation::windowed: return std::pow(1 - std::pow(d / r, 4), 2) / (d * d);
      case Attenuation::gltf: return (1 - std::pow(d / r, 4)) / (d * d);
    }
    return 0.0;
  };
  Scene scene = make_plane(20);
  const glm::dvec3 at(0, 2, 0);
  scene.lights = {point_light(at, r)};
  for (const ValueRow& row : rows<Attenuation>())
    for (const RangeKind kind : {RangeKind::source, RangeKind::windowed}) {
      Settings s = closed_settings();
      s.attenuation = static_cast<Attenuation>(row.value);
      s.range.kind = kind;
      const Truth truth = truth_of(scene, s);
      each_surface(truth, s, [&](glm::dvec3 p, size_t i) {
        const double d = glm::distance(p, at);
        const double window = kind == RangeKind::windowed ? std::pow(1 - std::pow(d / r, 4), 2) : 1;
        expect_close(truth.lit[i].x, d < r ? expected(s.attenuation, d) * window * at.y / d : 0, i);
      });
    }
}

TEST(Reference, ALightsOwnCoefficientsComeFirst) {
  Scene scene = make_plane(20);
  scene.lights = {point_light({0, 2, 0})};
  scene.lights[0].coefficients = {1, 0.3, 0.2};
  Settings s = closed_settings();
  s.attenuation = Attenuation::windowed;
  const Truth truth = truth_of(scene, s);
  each_surface(truth, s, [&](glm::dvec3 p, size_t i) {
    const double d = glm::distance(p, glm::dvec3(0, 2, 0));
    expect_close(truth.lit[i].x, 2 / d / (1 + 0.3 * d + 0.2 * d * d), i);
  });
}

TEST(Reference, LightAddsUp) {
  Settings s = closed_settings();
  s.shading = {ShadingModel::ggx, kExponentFromRoughness, 0.04};
  s.attenuation = Attenuation::linear;
  Scene scene = make_plane(20, {.base_colour = {0.7f, 0.4f, 0.2f, 1}, .roughness = 0.4f, .metal = 0.3f});
  const std::vector<Light> lights = {point_light({0, 2, 0}, 12), point_light({3, 1, -2}, 8, {0.2, 0.9, 2})};
  scene.lights = lights;
  const Truth both = truth_of(scene, s);
  scene.lights = {lights[0]};
  const Truth first = truth_of(scene, s);
  scene.lights = {lights[1]};
  const Truth second = truth_of(scene, s);
  each_surface(both, s, [&](glm::dvec3, size_t i) {
    for (int k = 0; k < 3; ++k) expect_close(both.lit[i][k], first.lit[i][k] + second.lit[i][k], i);
  });
}

// Equal light from the whole hemisphere: the directions' heights are 1/2n, 3/2n, …, so their mean is 1/2 exactly, and
// lights of 2/n each must show a white Lambert surface as 1.
TEST(Reference, AWhiteSurfaceVanishesInTheFurnace) {
  constexpr int n = 2000;
  Scene scene = make_plane(20);
  for (int i = 0; i < n; ++i) {
    const double height = (2 * i + 1) / (2.0 * n), side = std::sqrt(1 - height * height), turn = 2.4 * i;
    Light l;
    l.kind = LightKind::directional;
    l.direction = -glm::dvec3(side * std::cos(turn), height, side * std::sin(turn));
    l.colour = glm::dvec3(2.0 / n);
    scene.lights.push_back(l);
  }
  Settings s = closed_settings({16, 9});
  const Truth truth = truth_of(scene, s);
  each_surface(truth, s, [&](glm::dvec3, size_t i) { expect_close(truth.lit[i].x, 1, i); });
  // A rough microfacet surface sends back less than arrives, whatever its colour (single scattering loses some).
  s.shading.model = ShadingModel::ggx;
  scene.materials[0].metal = 1;
  const Truth metal = truth_of(scene, s);
  each_surface(metal, s, [&](glm::dvec3, size_t i) {
    EXPECT_LE(metal.lit[i].x, 1);
    EXPECT_GT(metal.lit[i].x, 0.3);
  });
}

// The eye stands in the mirror direction of the light: every lobe is at its peak there.
class MirrorDirection : public ::testing::Test {
 protected:
  // A picture of one pixel looks from (-3, 4, 0) at the origin; the light is at (3, 4, 0).
  glm::dvec3 highlight(ShadingModel model, double exponent, float roughness) {
    Scene scene = make_plane(5, {.roughness = roughness});
    scene.lights = {point_light({3, 4, 0})};
    Settings s = closed_settings({1, 1});
    s.camera.position = {-3, 4, 0};
    s.camera.orientation = orientation_from_yaw_pitch(-90, -glm::degrees(std::atan2(4.0, 3.0)));
    s.shading = {model, exponent, 0.33};
    const Truth truth = truth_of(scene, s);
    EXPECT_EQ(truth.present[0], 1);
    EXPECT_LE(glm::distance(truth.position[0] + s.camera.position, glm::dvec3(0)), 1e-12);
    return truth.specular[0];
  }
};

TEST_F(MirrorDirection, PhongAndBlinnAreTheirFactorThere) {
  for (const ShadingModel m : {ShadingModel::phong, ShadingModel::blinn_phong}) {
    expect_close(highlight(m, 33, 0.5f).x, 0.33, 0);
    const double from_roughness = 2 / std::pow(0.5, 4) - 2;  // 30
    expect_close(highlight(m, kExponentFromRoughness, 0.5f).x, 0.33 * (from_roughness + 2) / 8, 0);
  }
}

TEST_F(MirrorDirection, GgxHasItsPeakThere) {
  const double cosine = 0.8, alpha2 = std::pow(0.5, 4);
  const double fresnel = 0.04 + 0.96 * std::pow(1 - cosine, 5);
  const double visibility = 0.25 / (cosine * std::sqrt(cosine * cosine * (1 - alpha2) + alpha2));
  expect_close(highlight(ShadingModel::ggx, 1, 0.5f).x, cosine * visibility * fresnel / alpha2, 0);
}

TEST_F(MirrorDirection, SmoothGgxIsClamped) {
  EXPECT_EQ(highlight(ShadingModel::ggx, 1, 0.0f).x, highlight(ShadingModel::ggx, 1, 0.02f).x);
}

TEST(Reference, NothingShinesOnTheSideTurnedAway) {
  Scene scene = make_plane(20, {.roughness = 0.1f});
  scene.lights = {point_light({0, -0.2, -3})};  // just below the plane, opposite the eye
  for (const ValueRow& row : rows<ShadingModel>()) {
    Settings s = closed_settings();
    s.shading = {static_cast<ShadingModel>(row.value), 8, 0.33};
    for (const glm::dvec3& lit : truth_of(scene, s).lit) EXPECT_EQ(lit, glm::dvec3(0)) << row.id;
  }
}

// Three corners with known places in the picture: what is seen between them follows from perspective alone.
TEST(Reference, AKnownTriangleInPerspective) {
  Scene scene = make_plane(1);
  // In view space (camera at the origin, along -Z): depths 2, 4 and 8.
  const glm::dvec3 p[] = {{-1, -1, -2}, {3, -2, -4}, {0, 5, -8}};
  scene.meshes[0].vertices = {corner(p[0], {1, 0, 0, 1}), corner(p[1], {0, 1, 0, 1}), corner(p[2], {0, 0, 1, 1})};
  scene.meshes[0].indices = {0, 1, 2};
  Settings s = closed_settings({64, 36});
  s.camera = {};
  s.camera.near = 0.1;
  s.ambient = 1;
  const double tan_half = std::tan(glm::radians(s.camera.fov / 2)), aspect = 64.0 / 36;
  const Truth truth = truth_of(scene, s);
  size_t seen = 0;
  for (int y = 0; y < 36; ++y)
    for (int x = 0; x < 64; ++x) {
      const size_t i = static_cast<size_t>(y * 64 + x);
      // Screen-space weights from signed areas, then each divided by its corner's depth (Heckbert 1989).
      const glm::dvec2 at(((x + 0.5) / 64 * 2 - 1) * tan_half * aspect, (1 - (y + 0.5) / 36 * 2) * tan_half);
      glm::dvec2 c[3];
      for (int k = 0; k < 3; ++k) c[k] = glm::dvec2(p[k]) / -p[k].z;
      const auto area = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 d) {
        return (b.x - a.x) * (d.y - a.y) - (b.y - a.y) * (d.x - a.x);
      };
      glm::dvec3 w(area(c[1], c[2], at), area(c[2], c[0], at), area(c[0], c[1], at));
      w /= area(c[0], c[1], c[2]);
      const bool inside = w.x > 0 && w.y > 0 && w.z > 0;
      EXPECT_EQ(bool(truth.present[i]), inside);
      if (!inside) continue;
      ++seen;
      const glm::dvec3 over_depth(w.x / 2, w.y / 4, w.z / 8);
      const glm::dvec3 weights = over_depth / (over_depth.x + over_depth.y + over_depth.z);
      for (int k = 0; k < 3; ++k) expect_close(truth.lit[i][k], weights[k], i);  // ambient 1 shows the vertex colour
    }
  EXPECT_GT(seen, 100u);
}

TEST(Reference, APointBesideItsTriangleIsMovedOntoIt) {
  const glm::dvec3 corners[] = {{-1, 0, -2}, {1, 0, -2}, {0, 1, -2}};
  const Ray beside{{0, 0, 0}, {0, -0.01, -1}};  // meets the plane below the lower edge
  const glm::dvec3 w = barycentrics(beside, corners);
  EXPECT_GE(std::min({w.x, w.y, w.z}), 0);
  EXPECT_NEAR(w.x + w.y + w.z, 1, 1e-15);
  EXPECT_NEAR(w.z, 0, 1e-15);
  const glm::dvec3 edge_on[] = {{0, 0, -1}, {0, 0, -2}, {0, 0, -3}};
  const glm::dvec3 any = barycentrics({{0, 0, 0}, {0, 0, -1}}, edge_on);
  EXPECT_NEAR(any.x + any.y + any.z, 1, 1e-12);
}

TEST(Reference, FarFromTheOriginNothingChanges) {
  Settings s = closed_settings();
  s.shading.model = ShadingModel::ggx;
  s.attenuation = Attenuation::windowed;
  Scene scene = make_plane(20, {.roughness = 0.4f});
  scene.lights = {point_light({0.5, 2.5, -1}, 12, glm::dvec3(9))};
  const Truth near = truth_of(scene, s);
  for (const double offset : {1.0, 1e3, 1e5, 1e7}) {
    Settings there = s;
    Scene moved = scene;
    const glm::dvec3 by(offset, -offset, offset);
    there.camera.position += by;
    moved.lights[0].position += by;
    moved.instances[0].world_from_object[3] += glm::dvec4(by, 0);
    const Truth far = truth_of(moved, there);
    each_surface(far, there, [&](glm::dvec3, size_t i) {
      for (int k = 0; k < 3; ++k) expect_close(far.lit[i][k], near.lit[i][k], i);
    });
  }
}

TEST(Reference, ASpotEndsAtItsCones) {
  Scene scene = make_plane(20);
  Light spot = point_light({0, 3, 0});
  spot.kind = LightKind::spot;
  spot.direction = {0, -1, 0};
  spot.inner_cos = std::cos(glm::radians(20.0)), spot.outer_cos = std::cos(glm::radians(40.0));
  scene.lights = {spot};
  const Settings s = closed_settings();
  const Truth truth = truth_of(scene, s);
  each_surface(truth, s, [&](glm::dvec3 p, size_t i) {
    const double cosine = 3 / glm::distance(p, spot.position);
    const double edge = std::clamp((cosine - spot.outer_cos) / (spot.inner_cos - spot.outer_cos), 0.0, 1.0);
    expect_close(truth.lit[i].x, cosine * edge * edge, i);
  });
}

TEST(Reference, MaterialsAreThoseOfGltf) {
  const Material material{
      .base_colour = {0.5f, 0.25f, 0.125f, 1}, .roughness = 0.5f, .metal = 0.25f, .emissive = {0.125f, 0, 0.5f}};
  Settings s = closed_settings({4, 2});
  s.ambient = 0.5;
  s.shading.model = ShadingModel::ggx;
  const glm::dvec3 base(0.5, 0.25, 0.125), emission(0.125, 0, 0.5);
  const glm::dvec3 albedo = base * 0.75, f0 = 0.04 * 0.75 + base * 0.25;
  const Truth ggx = truth_of(make_plane(50, material), s);
  s.shading.model = ShadingModel::blinn_phong;
  const Truth classic = truth_of(make_plane(50, material), s);
  each_surface(ggx, s, [&](glm::dvec3, size_t i) {
    for (int k = 0; k < 3; ++k) {
      expect_close(ggx.lit[i][k], 0.5 * (albedo[k] + f0[k]) + emission[k], i);
      expect_close(classic.lit[i][k], 0.5 * base[k] + emission[k], i);
    }
  });
  Material shown = material;
  shown.unlit = true;
  Scene unlit = make_plane(50, shown);
  unlit.lights = {point_light({0, 2, 0})};
  const Truth as_it_is = truth_of(unlit, s);
  each_surface(as_it_is, s, [&](glm::dvec3, size_t i) {
    for (int k = 0; k < 3; ++k) expect_close(as_it_is.lit[i][k], base[k], i);
  });
}

TEST(Reference, MistakesAreNeverTrue) {
  Scene scene = make_plane(20);
  scene.lights = {point_light({0, 2, 0}, 4)};
  Settings s = closed_settings();
  s.range.kind = RangeKind::threshold;
  s.attenuation = Attenuation::ramp;
  const Truth right = truth_of(scene, s);
  s.mistakes = {Mistake::range_shortcut, Mistake::tbn_precedence, Mistake::specular_ungated};
  EXPECT_EQ(truth_of(scene, s).lit, right.lit);
}

// The normal map's frame in the world, turned, scaled and mirrored with its object: red along the tangent, green along
// w * cross(normal, tangent), each as the object's own edges go.
TEST(Reference, ANormalMapTurnsWithItsObject) {
  const Settings s = closed_settings();
  Scene scene = make_plane(20);
  scene.materials[0].normal_texture.texture = 0;
  for (const double mirror : {1.0, -1.0}) {
    const glm::dmat3 turned(glm::mat4_cast(orientation_from_yaw_pitch(30, 0)));
    const glm::dmat3 world_from_object = turned * glm::dmat3(2 * mirror, 0, 0, 0, 2, 0, 0, 0, 2);
    scene.instances[0].world_from_object = glm::dmat4(world_from_object);
    const glm::dvec3 frame[] = {world_from_object * glm::dvec3(1, 0, 0),
                                world_from_object * glm::cross(glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0)),
                                world_from_object * glm::dvec3(0, 1, 0)};
    for (int k = 0; k < 3; ++k) {
      std::vector<SeenTexel> seen = seen_by_rays(scene, s);
      for (SeenTexel& t : seen)
        for (int c = 0; c < 3; ++c) t.normal[c] = c == k ? 1 : 0.5f;
      Reference reference(s, std::make_shared<const Scene>(scene), seen);
      EXPECT_TRUE(reference.run(1));
      each_surface(reference.truth(), s, [&](glm::dvec3, size_t i) {
        EXPECT_LE(glm::distance(reference.truth().normal[i], glm::normalize(frame[k])), kClosedForm) << mirror << k;
      });
    }
  }
}

TEST(Reference, ABackFacesNormalLooksAtTheCamera) {
  Settings s = closed_settings();
  s.camera.position.y = -6;
  s.camera.orientation = orientation_from_yaw_pitch(8, 40);
  const Truth truth = truth_of(make_plane(20, {.double_sided = true}), s);
  each_surface(truth, s, [&](glm::dvec3, size_t i) {
    EXPECT_LE(glm::distance(truth.normal[i], glm::dvec3(0, -1, 0)), kClosedForm);
  });
}

TEST(Reference, CountsThePairsThatAreInRange) {
  Scene scene = make_plane(20);
  scene.lights = {point_light({0, 2, 0}, 5), point_light({3, 1, 1}, 4)};
  const Settings s = closed_settings();
  Reference reference(s, std::make_shared<const Scene>(scene), seen_by_rays(scene, s));
  EXPECT_TRUE(reference.run(2));
  uint64_t expected = 0;
  each_surface(reference.truth(), s, [&](glm::dvec3 p, size_t) {
    for (const Light& l : scene.lights) expected += glm::distance(p, l.position) < l.range;
  });
  EXPECT_GT(expected, 20u);
  EXPECT_EQ(reference.lit_pairs(), expected);
}

TEST(Reference, DoesNotDependOnThreadsOrInterruptions) {
  Scene scene = make_plane(20);
  scene.lights = {point_light({0, 2, 0}), point_light({2, 1, 1})};
  const Settings s = closed_settings();
  const Truth one = truth_of(scene, s, 1), three = truth_of(scene, s, 3);
  EXPECT_EQ(one.lit, three.lit);
  Reference stopped(s, std::make_shared<const Scene>(scene), seen_by_rays(scene, s));
  std::atomic<bool> cancel{true};
  EXPECT_FALSE(stopped.run(2, &cancel));
  EXPECT_LT(stopped.progress(), 1);
  cancel = false;
  EXPECT_TRUE(stopped.run(2, &cancel));
  EXPECT_EQ(stopped.progress(), 1);
  EXPECT_EQ(stopped.truth().lit, one.lit);
  EXPECT_GT(stopped.lit_pairs(), 0u);
}

TEST(Reference, GoesOnWhereItsTimeWasUp) {
  const Scene scene = make_plane(20);
  const Settings s = closed_settings();
  Reference sliced(s, std::make_shared<const Scene>(scene), seen_by_rays(scene, s));
  EXPECT_FALSE(sliced.run(1, nullptr, 0));
  EXPECT_GT(sliced.progress(), 0);
  for (double last = 0; !sliced.run(1, nullptr, 0.001); last = sliced.progress()) EXPECT_GE(sliced.progress(), last);
  EXPECT_EQ(sliced.truth().lit, truth_of(scene, s, 1).lit);
}

TEST(Reference, TheBackgroundIsTheSettings) {
  Settings s = closed_settings({4, 4});
  s.camera.orientation = orientation_from_yaw_pitch(0, 80);  // away from the plane
  s.background.fill = BackgroundFill::colour;
  s.background.colour = {0.1, 0.2, 0.3};
  const Truth truth = truth_of(make_plane(5), s);
  for (size_t i = 0; i < truth.pixels(); ++i) {
    EXPECT_EQ(truth.present[i], 0);
    EXPECT_EQ(truth.lit[i], s.background.colour);
  }
}

}  // namespace
}  // namespace gbl::test
