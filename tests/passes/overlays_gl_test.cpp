// Views that are made to be laid over others: what they mark is so, and laid over a picture they change nothing else.
#include <glm/gtc/matrix_transform.hpp>

#include "renderer/frame/frame_lights.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class Laid : public GlTest {};

Picture numbers(Stage& stage, View v, const Settings& s) {
  stage.draw(s);
  stage.renderer.draw_numbers(v, s, stage.scene, stage.targets, {{0, 0}, {1, 1}, s.size});
  return picture_of(stage.targets.canvases.numbers().texture);
}

// Pixels with numbers whose first one is `wanted`.
size_t pixels_of(const Picture& p, float wanted) {
  return static_cast<size_t>(
      std::count_if(p.texels.begin(), p.texels.end(), [&](const glm::vec4& t) { return t.w > 0.5f && t.x == wanted; }));
}
double sum(const Picture& p) {
  double total = 0;
  for (const glm::vec4& t : p.texels) total += t.w > 0.5f ? double(t.x) : 0;
  return total;
}

Settings volumes(LightCull cull) {
  Settings s = settings_for(yard());
  s.lights.method = LightMethod::volumes;
  s.lights.cull = cull;
  return s;
}

// Inside the range of a light, which it then picks.
Settings inside_a_light(LightCull cull) {
  Settings s = volumes(cull);
  s.lights.count = 4;
  const std::vector<Light> lights = lights_of(s, yard().scene());
  s.camera.position = lights[0].position + glm::dvec3(0, 0.2, 0.4) * lights[0].range;
  s.view.pick = 0;
  return s;
}

TEST_F(Laid, FootprintTellsLitFromCoveredFromLost) {
  Stage stage(yard());
  const Picture sound = numbers(stage, View::footprint, inside_a_light(LightCull::flip_safe));
  EXPECT_GT(pixels_of(sound, 2), 0u) << "lit";
  EXPECT_EQ(pixels_of(sound, 3) + pixels_of(sound, 4), 0u);
  const Picture lost = numbers(stage, View::footprint, inside_a_light(LightCull::back));
  EXPECT_EQ(pixels_of(lost, 3), pixels_of(sound, 2)) << "seen from inside its front faces are behind the camera";
  EXPECT_EQ(pixels_of(lost, 2), 0u);

  Settings outside = volumes(LightCull::flip_safe);
  Picture once = numbers(stage, View::footprint, outside);
  while (pixels_of(once, 2) == 0 && ++outside.view.pick < outside.lights.count)
    once = numbers(stage, View::footprint, outside);
  ASSERT_GT(pixels_of(once, 2), 0u);
  EXPECT_GT(pixels_of(once, 1), 0u) << "ground behind the sphere";
  outside.lights.cull = LightCull::none;
  const Picture twice = numbers(stage, View::footprint, outside);
  EXPECT_EQ(pixels_of(twice, 4), pixels_of(once, 2)) << "both faces of the sphere shade it";
}

TEST_F(Laid, FootprintIsOfThePickedLightAloneAndLeavesTheCountsOfAll) {
  Stage stage(yard());
  Settings s = volumes(LightCull::flip_safe);
  const Picture all = numbers(stage, View::lights_per_pixel, s);
  double lit = 0;
  for (s.view.pick = 0; s.view.pick < s.lights.count; ++s.view.pick)
    lit += static_cast<double>(pixels_of(numbers(stage, View::footprint, s), 2));
  EXPECT_EQ(lit, sum(all)) << "each light's lit pixels, added up";
  stage.renderer.draw_numbers(View::lights_per_pixel, s, stage.scene, stage.targets, {{0, 0}, {1, 1}, s.size});
  EXPECT_EQ(sum(picture_of(stage.targets.canvases.numbers().texture)), sum(all));
}

TEST_F(Laid, MiscountedPairsAreNoneForSoundMethodsAndAsManyAsAreLost) {
  Stage stage(yard());
  for (const LightMethod m : {LightMethod::fullscreen_radius, LightMethod::volumes, LightMethod::quads,
                              LightMethod::volumes_stencil, LightMethod::clustered}) {
    Settings s = volumes(LightCull::flip_safe);
    s.lights.method = m;
    const Picture p = numbers(stage, View::miscounted_pairs, s);
    EXPECT_GT(pixels_of(p, 0), 0u);
    EXPECT_TRUE(std::all_of(p.texels.begin(), p.texels.end(), [](const glm::vec4& t) { return t.x == 0; }))
        << row(m).id;
  }
  const Settings lost = inside_a_light(LightCull::back);
  const PairCounts pairs = stage.pairs(lost);
  const double in_range = sum(numbers(stage, View::lights_per_pixel, lost));
  const double missed = sum(numbers(stage, View::miscounted_pairs, lost));
  EXPECT_LT(missed, 0);
  EXPECT_EQ(missed, in_range - double(*pairs.lit));
}

// A rectangle of two triangles that faces the camera, `behind` it a wall that is ten times as large.
Scene cards(bool turned_away, bool double_sided) {
  Scene s;
  s.name = "cards";
  const auto card = [](double half, bool away) {
    Mesh m;
    const glm::vec3 n(0, 0, away ? -1 : 1);
    for (const auto& [x, y] : {std::pair(-1.0, -1.0), {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
      m.vertices.push_back({.position = glm::vec3(glm::dvec3(x, y, 0) * half), .normal = n, .tangent = {1, 0, 0, 1}});
    m.indices = away ? std::vector<uint32_t>{0, 2, 1, 0, 3, 2} : std::vector<uint32_t>{0, 1, 2, 0, 2, 3};
    return m;
  };
  s.meshes = {card(1, turned_away), card(10, false)};
  s.materials = {{.name = "card", .base_colour = {0.5f, 0.5f, 0.5f, 1}},
                 {.name = "wall", .base_colour = {0.8f, 0.8f, 0.8f, 1}}};
  s.materials[0].double_sided = double_sided;
  s.instances = {{"card", 0, 0, glm::dmat4(1)}, {"wall", 1, 1, glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -1))}};
  s.bounds = bounds_of(s);
  s.camera.position = {0, 0, 4};
  s.camera.near = 0.5, s.camera.far = 100;
  return s;
}

TEST_F(Laid, ATriangleIsAsLargeAsItIsOnScreen) {
  const GpuScene scene(std::make_shared<const Scene>(cards(false, false)));
  Stage stage(scene);
  Settings s = settings_for(yard(), {160, 90});
  s.camera = scene.scene().camera;
  const Picture p = numbers(stage, View::triangle_size, s);
  // A side of 2 at a distance of 4: so many pixels by the projection; the triangle is half of the square.
  const double side = 2 / (2 * 4 * std::tan(glm::radians(s.camera.fov) / 2)) * s.size.y;
  const glm::vec4 middle = p.texels[static_cast<size_t>(45 * 160 + 84)];  // beside the diagonal
  EXPECT_NEAR(double(middle.x), side * side / 2, side * side * 1e-4) << "gradients in float";
  const Picture wire = numbers(stage, View::wire, s);
  EXPECT_EQ(wire.texels[static_cast<size_t>(45 * 160 + 90)].x, 0) << "off the diagonal";
  EXPECT_GT(wire.texels[static_cast<size_t>(45 * 160 + 80)].x, 0.2f) << "on it";
}

TEST_F(Laid, FacesTurnedAwayAreThoseSeenAndThoseCulledInFront) {
  Settings s = settings_for(yard(), {160, 90});
  const auto in_the_middle = [&](bool away, bool double_sided) {
    const GpuScene scene(std::make_shared<const Scene>(cards(away, double_sided)));
    Stage stage(scene);
    s.camera = scene.scene().camera;
    const Picture p = numbers(stage, View::back_faces, s);
    EXPECT_EQ(p.texels[0].x, 0) << "the wall alone";
    return p.texels[static_cast<size_t>(45 * 160 + 84)].x;
  };
  EXPECT_EQ(in_the_middle(false, false), 0);
  EXPECT_EQ(in_the_middle(true, false), 1) << "culled: a hole before the wall";
  EXPECT_EQ(in_the_middle(true, true), 1) << "seen from behind";
  EXPECT_EQ(in_the_middle(false, true), 0);
}

TEST_F(Laid, OverdrawFollowsTheOrderOfDrawing) {
  Stage stage(yard());
  Settings s = settings_for(yard());
  s.draw_order = DrawOrder::near_far;
  const Picture sorted = numbers(stage, View::overdraw, s);
  const auto seen = static_cast<double>(
      std::count_if(sorted.texels.begin(), sorted.texels.end(), [](const glm::vec4& t) { return t.w > 0.5f; }));
  EXPECT_EQ(pixels_of(sorted, 0), 0u) << "what is seen was written";
  EXPECT_GE(sum(sorted), seen);
  s.draw_order = DrawOrder::far_near;
  EXPECT_GT(sum(numbers(stage, View::overdraw, s)), sum(sorted));
}

TEST_F(Laid, ChecksNameTheGravestFault) {
  Stage stage(yard());
  Settings s = settings_for(yard());
  EXPECT_EQ(pixels_of(numbers(stage, View::checks, s), 2), 0u);
  s.exposure = 1000;
  EXPECT_GT(pixels_of(numbers(stage, View::checks, s), 1), 1000u);
  s.exposure = 1;
  s.normal.encoding = NormalEncoding::xyz8;
  s.mistakes = {Mistake::decode_not_normalised};
  EXPECT_GT(pixels_of(numbers(stage, View::checks, s), 2), 0u);
}

TEST_F(Laid, TileEdgesStandWhereListsBegin) {
  Stage stage(yard());
  Settings s = settings_for(yard(), {160, 90});
  s.lights.method = LightMethod::clustered;
  const unsigned tile = static_cast<unsigned>(stage.draw(s).lists.value().tile_px);
  ASSERT_TRUE(tile == 8 || tile == 16) << tile;
  const unsigned columns = (160 + tile - 1) / tile, rows = (90 + tile - 1) / tile;
  EXPECT_EQ(pixels_of(numbers(stage, View::tile_edges, s), 1), 160u * 90 - (160 - columns) * (90 - rows));
  s.lights.count = 0;
  EXPECT_EQ(pixels_of(numbers(stage, View::tile_edges, s), 1), 0u) << "nothing is listed";
}

bool same(const Image& a, const Image& b, size_t i) {
  return std::equal(a.rgba.begin() + static_cast<std::ptrdiff_t>(4 * i),
                    a.rgba.begin() + static_cast<std::ptrdiff_t>(4 * i + 4),
                    b.rgba.begin() + static_cast<std::ptrdiff_t>(4 * i));
}

TEST_F(Laid, OneLaidOverAPictureChangesWhatItMarksAndNothingElse) {
  Stage stage(yard());
  for (const ViewRow& v : views()) {
    if (!v.marks) continue;
    Settings s = v.view == View::miscounted_pairs ? inside_a_light(LightCull::back) : volumes(LightCull::flip_safe);
    if (v.view == View::tile_edges) s.lights.method = LightMethod::clustered;
    s.exposure = 30;  // some of it is above white
    stage.draw(s);
    const Image plain = stage.view(View::final, s, {.overlays = true}), own = stage.view(v.view, s);
    const Picture marked = numbers(stage, v.view, s);
    s.view.overlays = {{v.id, 1}};
    const Image laid = stage.view(View::final, s, {.overlays = true});
    s.view.overlays = {{v.id, 0.5}};
    const Image half = stage.view(View::final, s, {.overlays = true});
    const int width = s.size.x;
    size_t covered = 0, wrong = 0, unlike = 0;
    for (size_t i = 0; i < plain.rgba.size() / 4; ++i) {
      const auto x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
      const glm::vec4& t = marked.texels[static_cast<size_t>((s.size.y - 1 - y) * width + x)];
      const bool marks = t.w > 0.5f && t.x != 0;
      covered += marks;
      if (!marks) wrong += !same(laid, plain, i) || !same(half, plain, i);
      if (marks && v.view != View::wire) unlike += !same(laid, own, i);  // wires have a colour of their own
    }
    EXPECT_EQ(wrong, 0u) << v.id;
    EXPECT_EQ(unlike, 0u) << v.id;
    EXPECT_EQ(covered > 0, v.view != View::back_faces) << v.id << ": what the scene shows";
    EXPECT_EQ(half != laid, covered > 0) << v.id;
  }
}

// While something moves nothing is counted beforehand: the overlay counts by itself.
TEST_F(Laid, WhatAnOverlayCountsIsTimedApart) {
  if (!gl::device().features.has(Feature::timer_query)) GTEST_SKIP() << "no timer queries here";
  Stage stage(yard());
  Settings s = volumes(LightCull::flip_safe);
  s.view.overlays = {{.view = row(View::lights_per_pixel).id}};
  FrameReport report = stage.draw(s);
  stage.view(View::final, s, {.overlays = true});
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << "a timer began within another";
  stage.renderer.collect(stage.targets, report, true);
  std::vector<std::string> last;
  for (const PassTime& p : report.passes) last.push_back(p.pass);
  ASSERT_GE(last.size(), 3u);
  EXPECT_EQ(std::vector(last.end() - 3, last.end()), (std::vector<std::string>{"views", "count", "views"}));
}

}  // namespace
}  // namespace gbl::test
