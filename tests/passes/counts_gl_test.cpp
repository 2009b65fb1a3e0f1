// What tested, shaded and lit pairs are, and that no count depends on chance, size or number of lights.
#include <map>

#include "renderer/base/random.h"
#include "renderer/frame/attachments.h"
#include "renderer/frame/estimate.h"
#include "renderer/frame/resolved_frame.h"
#include "renderer/frame/validate.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class Counts : public GlTest {};

Settings counted(LightMethod method, glm::ivec2 size = {64, 36}) {
  Settings s = settings_for(yard(), size);
  s.lights.method = method;
  return s;
}

Settings with_volumes(LightCull cull, VolumeFit fit = VolumeFit::circumscribed) {
  Settings s = counted(LightMethod::volumes);
  s.lights.cull = cull;
  s.lights.volume.fit = fit;
  return s;
}

uint64_t surface_pixels(Stage& stage, const Settings& s) {
  uint64_t n = 0;
  for (const glm::vec4& t : stage.lit(s).texels) n += t.a == 1;
  return n;
}

// Per pixel: tested, shaded, shaded in range; and in a, by a pass of its own, the lights whose range reaches it.
Picture count_picture(Stage& stage, const Settings& s) {
  stage.pairs(s);
  Picture p = picture_of(stage.targets.canvases.counts().texture);
  const Picture lit = picture_of(stage.targets.canvases.counts_lit().texture);
  for (size_t i = 0; i < p.count(); ++i) p.texels[i].a = lit.texels[i].r;
  return p;
}

TEST_F(Counts, FullScreenTestsAndShadesEveryPair) {
  Stage stage(yard());
  for (const int lights : {0, 1, 64, 257}) {
    Settings s = counted(LightMethod::fullscreen);
    s.lights.count = lights;
    const PairCounts pairs = stage.pairs(s);
    const uint64_t surface = surface_pixels(stage, s);
    ASSERT_GT(surface, 0u);
    ASSERT_LT(surface, 64u * 36u) << "some background is wanted";
    EXPECT_EQ(pairs.tested, surface * lights);
    EXPECT_EQ(pairs.shaded, surface * lights);
    EXPECT_EQ(pairs.lit.value() == 0, lights == 0);
  }
}

TEST_F(Counts, DistanceTestShadesExactlyThePairsInRange) {
  Stage stage(yard());
  const Settings s = counted(LightMethod::fullscreen_radius);
  const PairCounts pairs = stage.pairs(s);
  EXPECT_EQ(pairs.tested, surface_pixels(stage, s) * s.lights.count);
  EXPECT_GT(pairs.shaded, 0u);
  EXPECT_EQ(pairs.shaded, pairs.lit.value());
}

TEST_F(Counts, VolumesShadeAtLeastThePairsInRangeAndLessThanAll) {
  Stage stage(yard());
  const PairCounts all = stage.pairs(counted(LightMethod::fullscreen));
  uint64_t coarser = ~uint64_t(0);
  for (const VolumeLevel level : {VolumeLevel::l0, VolumeLevel::l2, VolumeLevel::l4}) {
    Settings s = with_volumes(LightCull::flip_safe);
    s.lights.volume.level = level;
    const PairCounts pairs = stage.pairs(s);
    EXPECT_EQ(pairs.tested, pairs.shaded);  // a fragment of a volume is a pair that is shaded
    EXPECT_EQ(pairs.lit, all.lit);
    EXPECT_GE(pairs.shaded, pairs.lit.value());
    EXPECT_LT(pairs.shaded, all.shaded / 2);
    EXPECT_LT(pairs.shaded, coarser) << "a finer mesh wastes less";
    coarser = pairs.shaded;
  }
}

// What is tested for each pair that is lit: no more than twice where a light is four tiles wide, and where it is smaller
// what a square of tiles over a square light would read, and a third more (tests/light/light_clusters_test.cpp).
TEST_F(Counts, ClustersTestFewMoreLightsThanReachAPixel) {
  int looked = 0;
  for (const char* name : {"builtin:hall", "builtin:terrain", "builtin:city"}) {
    const GpuScene scene(std::make_shared<const Scene>(load_scene(name)));
    Stage stage(scene);
    for (const int lights : {64, 1024}) {
      Settings s = settings_for(scene, {640, 360});
      s.lights.method = LightMethod::clustered;
      s.lights.count = lights;
      const std::optional<ListReport> lists = stage.draw(s).lists;
      const PairCounts pairs = stage.pairs(s);
      ASSERT_TRUE(lists.has_value());
      ASSERT_GT(pairs.lit.value(), 5000u) << name;
      EXPECT_EQ(pairs.shaded, pairs.lit.value()) << name << " " << lights;
      EXPECT_GT(lists->entries, 0u);
      if (!lists->looked) {  // it would take as long as three tests for each pixel
        EXPECT_LE(pairs.tested, 3u * 640 * 360) << name << " " << lights;
        continue;
      }
      ++looked;
      const double tiles = lists->light_px / lists->tile_px;
      const double most = tiles >= 4 ? 2 : 1.3 * std::pow(1 + 1 / tiles, 2);
      EXPECT_LE(double(pairs.tested), most * double(pairs.lit.value())) << name << " " << lights << ", " << tiles;
    }
  }
  EXPECT_GE(looked, 4);
}

// Lamps and a sun that all pixels read: places that are left free between them are no tests.
TEST_F(Counts, WhatFillsAListUpIsNoTest) {
  Scene scene = make_yard();
  for (int i = 0; i < 6; ++i) {
    Light l;
    l.position = {20, 8, 20}, l.range = kEndless;
    if (i == 2) l.kind = LightKind::directional;
    scene.lights.push_back(l);
  }
  const GpuScene uploaded(std::make_shared<const Scene>(std::move(scene)));
  Stage stage(uploaded);
  Settings s = counted(LightMethod::clustered);
  s.lights.source = LightSource::scene, s.range.kind = RangeKind::none;
  EXPECT_EQ(stage.draw(s).lists->everywhere, 6);
  const PairCounts pairs = stage.pairs(s);
  EXPECT_EQ(pairs.tested, 6 * surface_pixels(stage, s));
  EXPECT_EQ(pairs.shaded, pairs.tested);
}

// Wherever a position is stored and however it is rounded: what reaches it is in the list that its pixel reads.
TEST_F(Counts, ClustersLoseNoPairWhereverPositionsAreStored) {
  for (const double origin : {0.0, 900.0}) {
    const GpuScene scene(std::make_shared<const Scene>(make_yard(origin)));
    Stage stage(scene);
    for_each_row<PositionSource>([&](PositionSource source, auto& r) {
      for (const BackgroundSkip skip : {BackgroundSkip::depth, BackgroundSkip::none}) {
        Settings s = settings_for(scene, {160, 90});
        s.lights.method = LightMethod::clustered, s.lights.count = 300, s.lights.range_scale = 1.5;
        s.position.source = source, s.background.skip = skip;
        s.camera.far = 60;  // the last walls lie near it
        if (!validate(s, {gl::device().features}).empty()) return;
        const PairCounts pairs = stage.pairs(s);
        EXPECT_GT(pairs.lit.value(), 10000u) << r.id;
        EXPECT_EQ(pairs.shaded, pairs.lit.value()) << r.id << " " << origin << " " << static_cast<int>(skip);
      }
    });
  }
}

// Written 12, read 12, and out: presets that fold write no sums and read nothing twice.
TEST_F(Counts, TrafficIsThatOfTheAttachments) {
  Stage stage(yard());
  Settings s = counted(LightMethod::clustered);
  s.layout = Layout::compact;
  const auto traffic = [&](AccumulationTargets targets) {
    s.accumulation = {AccumulationFormat::rgba16f, targets};
    std::map<std::string, PassTraffic> by_pass;
    for (const PassTraffic& t : stage.draw(s).traffic) by_pass[t.pass] = t;
    return by_pass;
  };
  auto folded = traffic(AccumulationTargets::folded), split = traffic(AccumulationTargets::split);
  const int gbuffer = gbuffer_bytes_per_pixel(resolve_frame(s, yard().scene(), {}).settings);
  EXPECT_EQ(folded["geometry"].written, gbuffer);
  EXPECT_EQ(folded["geometry"].read, 0);
  EXPECT_EQ(folded["lighting"].read, gbuffer);
  EXPECT_EQ(folded["lighting"].written, 8) << "lit, in half floats";
  EXPECT_EQ(folded.count("combine"), 0u);
  EXPECT_EQ(split["lighting"].written, 16) << "two sums in half floats";
  EXPECT_EQ(split["combine"].read, gbuffer + 16);
  EXPECT_EQ(split["combine"].written, 16);
}

// The lighting's draws: all but those of a frame without lights.
int lighting_draws(Stage& stage, Settings s) {
  const int all = stage.draw(s).draw_calls;
  s.lights.count = 0;
  return all - stage.draw(s).draw_calls;
}

TEST_F(Counts, DrawCallsGrowWithTheLightsOnlyWhereTheMethodSaysSo) {
  Stage stage(yard());
  for (const int lights : {1, 64, 300}) {
    Settings s = counted(LightMethod::fullscreen);
    s.lights.count = lights;
    EXPECT_EQ(lighting_draws(stage, s), 1);
    s.lights.method = LightMethod::volumes;
    EXPECT_EQ(lighting_draws(stage, s), lights);
    s.lights.method = LightMethod::volumes_stencil;
    EXPECT_EQ(lighting_draws(stage, s), 2 * lights);
    s.lights.method = LightMethod::volumes_instanced;
    EXPECT_EQ(lighting_draws(stage, s), 2) << "flip-safe: those that the camera is inside of, and the others";
    s.lights.cull = LightCull::front;
    EXPECT_EQ(lighting_draws(stage, s), 1);
  }
}

// The same meshes, so the same pairs, whatever the rule; also the failing ones, from inside and outside.
TEST_F(Counts, InstancedVolumesShadeThePairsOfSingleOnes) {
  Stage stage(yard());
  for_each_row<LightCull>([&](LightCull cull, auto& r) {
    for (const VolumeFit fit : {VolumeFit::inscribed, VolumeFit::circumscribed}) {
      Settings s = with_volumes(cull, fit);
      const Picture single = count_picture(stage, s);
      s.lights.method = LightMethod::volumes_instanced;
      EXPECT_TRUE(same_bits(count_picture(stage, s), single)) << r.id;
    }
  });
}

// Less and less is shaded that is not lit: without a depth test; surfaces behind the volume left out; those before it,
// too. What the stencil leaves is the mesh's excess over its sphere.
TEST_F(Counts, ADepthTestLowersWhatIsShadedInVain) {
  Stage stage(terrain());
  Settings s = settings_for(terrain(), {320, 180});
  s.lights.method = LightMethod::volumes;
  s.lights.cull = LightCull::front;
  s.lights.volume.level = VolumeLevel::l3;
  const PairCounts none = stage.pairs(s);
  s.lights.volume.depth = VolumeDepth::greater_equal;
  const PairCounts behind = stage.pairs(s);
  s.lights.method = LightMethod::volumes_stencil;
  const PairCounts inside = stage.pairs(s);
  EXPECT_EQ(none.lit, behind.lit);
  EXPECT_EQ(none.lit, inside.lit);
  EXPECT_LT(double(behind.shaded), 0.9 * double(none.shaded));
  EXPECT_LT(inside.shaded, behind.shaded);
  EXPECT_GE(inside.shaded, *inside.lit);
  EXPECT_LE(double(inside.shaded), 1.05 * double(*inside.lit));
  EXPECT_EQ(inside.tested, inside.shaded) << "the draw that marks reads no record for a pixel";
}

// The marks of a light are gone when it is done: not one is left after a frame, and none after a count.
TEST_F(Counts, NoMarkIsLeftInTheStencil) {
  for (const auto& [format, texel, at] : {std::tuple(DepthFormat::d24, 4, 0), {DepthFormat::d32f, 8, 4}}) {
    Stage stage(yard());
    Settings s = counted(LightMethod::volumes_stencil);
    s.depth.format = format;
    const auto marks = [&, texel = texel, at = at] {  // clang 14 captures no bindings
      const std::vector<uint8_t> bytes = stored_bytes(*stage.targets.frame.texture(Stores::light_depth));
      int left = 0;
      for (int i = 0; i < s.size.x * s.size.y; ++i) left += bytes[texel * i + at] != 0;
      return left;
    };
    stage.draw(s);
    EXPECT_EQ(marks(), 0) << row(format).id;
    EXPECT_GT(stage.pairs(s).shaded, 0u);
    EXPECT_EQ(marks(), 0) << row(format).id;
  }
}

// Bounds and discs: a fragment is a pair that is read and shaded. Bounds are wider than any mesh is; of the sphere's
// outline they waste a fifth.
TEST_F(Counts, RectanglesShadeTheCornersToo) {
  Stage stage(yard());
  const PairCounts quads = stage.pairs(counted(LightMethod::quads));
  EXPECT_EQ(quads.tested, quads.shaded);
  EXPECT_GE(quads.shaded, quads.lit.value());
  Settings finest = with_volumes(LightCull::flip_safe);
  finest.lights.volume.level = VolumeLevel::l4;
  const PairCounts volumes = stage.pairs(finest);
  EXPECT_GT(quads.shaded, volumes.shaded);
  EXPECT_LT(quads.shaded, volumes.shaded * 2);
}

// A list leaves out most lights, the distance test all others that do not reach.
TEST_F(Counts, ListsAreTestedAndOnlyPairsInRangeAreShaded) {
  Stage stage(yard());
  const PairCounts all = stage.pairs(counted(LightMethod::fullscreen));
  for (const LightMethod method : {LightMethod::tiled, LightMethod::clustered}) {
    if (!gl::device().features.has(row(method).needs)) continue;
    const PairCounts pairs = stage.pairs(counted(method));
    EXPECT_EQ(pairs.shaded, pairs.lit.value()) << row(method).id;
    EXPECT_EQ(pairs.lit, all.lit) << row(method).id;
    EXPECT_GT(pairs.tested, pairs.shaded) << row(method).id;
    EXPECT_LT(pairs.tested, all.tested / 2) << row(method).id;
  }
}

// The yard in feet, so to speak: a hundred units wide, its lights of range 20.
const GpuScene& wide_yard() {
  static const GpuScene scene([] {
    Scene s = make_yard();
    for (Instance& i : s.instances)
      i.world_from_object = glm::scale(glm::dmat4(1), glm::dvec3(2.5)) * i.world_from_object;
    s.light_grid = {.extent = {100, 100}, .height = 8, .pivot = {50, 50}};
    s.camera.position *= 2.5;
    s.bounds = bounds_of(s);
    return std::make_shared<const Scene>(s);
  }());
  return scene;
}

TEST_F(Counts, ListsAreTight) {
  Stage stage(wide_yard());
  Settings s = settings_for(wide_yard(), {320, 180});
  s.lights.count = 64, s.lights.range_scale = 20 / 12.5;
  for (const LightMethod method : {LightMethod::clustered, LightMethod::tiled}) {
    if (!gl::device().features.has(row(method).needs)) continue;
    s.lights.method = method;
    const PairCounts pairs = stage.pairs(s);
    for (const Light& l : stage.targets.drawn->lights) ASSERT_NEAR(l.range, 20, 1e-9);
    const auto lit = static_cast<double>(pairs.lit.value());
    EXPECT_LE(static_cast<double>(pairs.shaded) / lit, 1.1) << row(method).id;
    EXPECT_LE(static_cast<double>(pairs.tested) / lit, 3) << row(method).id;
  }
}

// What `auto` decides by: nobody knows the surfaces beforehand, but the size of the numbers is right.
TEST_F(Counts, EstimatesAreOfTheirOrder) {
  Stage stage(yard());
  for (const int count : {4, 64, 1024})
    for_each_row<LightMethod>([&](LightMethod method, auto& r) {
      if (!r.sound() || method == LightMethod::auto_) return;
      Settings s = counted(method, {160, 90});
      s.lights.count = count;
      const PairCounts pairs = stage.pairs(s);
      const LightWork work = work_of(method, lights_in_view(s, stage.targets.drawn->lights));
      for (const auto& [estimated, counted] :
           {std::pair(work.tested, pairs.tested), std::pair(work.shaded, pairs.shaded)}) {
        EXPECT_GT(estimated, static_cast<double>(counted) / 4) << r.id << ", " << count;
        EXPECT_LT(estimated, static_cast<double>(counted) * 4) << r.id << ", " << count;
      }
    });
}

TEST_F(Counts, NoCullingCountsTwiceFromOutside) {
  Stage stage(yard());
  Settings s = with_volumes(LightCull::front);
  s.camera.position = {20, 30, 60};  // outside every volume
  s.camera.orientation = orientation_from_yaw_pitch(0, -35);
  const Picture once = count_picture(stage, s);
  s.lights.cull = LightCull::none;
  const Picture twice = count_picture(stage, s);
  double pairs = 0;
  for (size_t i = 0; i < once.count(); ++i) {
    EXPECT_EQ(glm::vec3(twice.texels[i]), 2.0f * glm::vec3(once.texels[i]));
    EXPECT_EQ(twice.texels[i].a, once.texels[i].a);  // the lights themselves are as many as before
    pairs += once.texels[i].y;
  }
  EXPECT_GT(pairs, 0);
}

TEST_F(Counts, LightsPerPixelIsTheBruteForceCountForEverySoundMethod) {
  Stage stage(yard());
  for_each_row<LightMethod>([&](LightMethod method, auto& r) {
    if (!r.sound() || method == LightMethod::forward) return;  // that one pays for hidden fragments, too
    const Picture counts = count_picture(stage, counted(method));
    for (const glm::vec4& t : counts.texels) EXPECT_EQ(t.b, t.a) << r.id;
  });
  // The view shows what is missing: a method that loses lights counts fewer.
  const Picture inscribed = count_picture(stage, [] {
    Settings s = with_volumes(LightCull::flip_safe, VolumeFit::inscribed);
    s.lights.volume.level = VolumeLevel::l0;
    return s;
  }());
  int fewer = 0;
  for (const glm::vec4& t : inscribed.texels) {
    EXPECT_LE(t.b, t.a);
    fewer += t.b < t.a;
  }
  EXPECT_GT(fewer, 0);
}

// The GPU's count against distances in double from the stored depth; pixels nearer to a rim than float can tell are
// left out, and few.
TEST_F(Counts, LitPairsAreThoseOfTheFormula) {
  Stage stage(yard());
  const Settings s = counted(LightMethod::fullscreen_radius);
  const Picture counts = count_picture(stage, s);
  const std::vector<uint8_t> bytes = stored_bytes(*stage.targets.frame.texture(Stores::depth));
  const ViewRays rays = view_rays(s.camera, double(s.size.x) / s.size.y);
  int undecided = 0;
  for (int i = 0; i < int(counts.count()); ++i) {
    float depth;
    std::memcpy(&depth, &bytes[4 * i], 4);
    if (depth == 1) {
      EXPECT_EQ(counts.texels[i], glm::vec4(0)) << "background is never counted";
      continue;
    }
    const double x = (i % s.size.x + 0.5) / s.size.x * 2 - 1, y = (i / s.size.x + 0.5) / s.size.y * 2 - 1;
    const glm::dvec3 point =
        s.camera.position + range_from_depth(s.camera, depth) * (rays.forward + x * rays.right + y * rays.up);
    int lights = 0;
    bool near_a_rim = false;
    for (const Light& l : stage.targets.drawn->lights) {
      const double d = glm::distance(point, l.position);
      lights += d < l.range;
      near_a_rim |= std::abs(d - l.range) < 1e-3;  // float positions 60 units from the camera are good to some 1e-4
    }
    if (near_a_rim)
      ++undecided;
    else
      EXPECT_EQ(counts.texels[i].a, float(lights)) << i % s.size.x << ", " << i / s.size.x;
  }
  EXPECT_LT(undecided, int(counts.count()) / 100);
}

// Sizes that are no multiple of the reduction's blocks, one pixel included: the sums are those of the pixels.
TEST_F(Counts, SumsAreExactAtAnySize) {
  Stage stage(yard());
  for (const glm::ivec2 size : {glm::ivec2(1, 1), {3, 2}, {16, 16}, {17, 33}, {64, 36}, {131, 77}}) {
    const Settings s = counted(LightMethod::volumes, size);
    const PairCounts pairs = stage.pairs(s);
    glm::dvec4 sum(0);
    for (const glm::vec4& t : count_picture(stage, s).texels) sum += glm::dvec4(t);
    EXPECT_EQ(glm::dvec3(pairs.tested, pairs.shaded, pairs.lit.value()), glm::dvec3(sum.x, sum.y, sum.w));
  }
}

TEST_F(Counts, WithoutTheLitPassItIsUnknownNotZero) {
  Stage stage(yard());
  const Settings s = counted(LightMethod::volumes);
  const PairCounts with = stage.pairs(s);
  FrameReport report = stage.draw(s);
  EXPECT_FALSE(report.pairs);
  stage.renderer.count_pairs(s, yard(), stage.targets, false);
  stage.renderer.collect(stage.targets, report, true);
  ASSERT_TRUE(report.pairs);
  EXPECT_FALSE(report.pairs->lit);
  EXPECT_EQ(report.pairs->shaded, with.shaded);
}

// An answer that was under way when the next frame was drawn belongs to no frame any more.
TEST_F(Counts, OfAnEarlierFrameAreNotReportedForTheNext) {
  Stage stage(yard());
  stage.draw(counted(LightMethod::fullscreen));
  stage.renderer.count_pairs(counted(LightMethod::fullscreen), yard(), stage.targets, true);
  FrameReport report = stage.draw(counted(LightMethod::volumes));
  stage.renderer.collect(stage.targets, report, true);
  EXPECT_FALSE(report.pairs) << report.pairs->shaded << " pairs of the frame before";
}

TEST_F(Counts, SixteenThousandLightsAreDrawnAndCounted) {
  Stage stage(yard());
  Settings s = counted(LightMethod::fullscreen_radius);
  s.lights.count = kMaxLights;
  const Picture reference = stage.lit(s);
  const uint64_t surface = surface_pixels(stage, s);
  const PairCounts loop = stage.pairs(s);
  EXPECT_EQ(loop.tested, surface * kMaxLights);  // 3e7: beyond what one float could count
  EXPECT_EQ(loop.shaded, loop.lit.value());
  s.lights.volume.level = VolumeLevel::l0;
  for_each_row<LightMethod>([&](LightMethod method, auto& r) {
    s.lights.method = method;
    // Forward shading stores other bits, and light by light it would draw the scene 16 384 times.
    if (!sound(s) || shading_of(method) != Shading::deferred) return;
    EXPECT_TRUE(like(stage.lit(s), reference, {.max_abs = 1e-5, .why = "float sums of the few lights in range"}))
        << r.id;
    const PairCounts pairs = stage.pairs(s);
    EXPECT_EQ(pairs.lit, loop.lit) << r.id;
    EXPECT_GE(pairs.shaded, loop.shaded) << r.id;
    EXPECT_LE(pairs.shaded, loop.tested) << r.id;
  });
  s.lights.count = 0;
  EXPECT_EQ(stage.pairs(s).tested, 0u);
}

}  // namespace
}  // namespace gbl::test
