// A frame is a function of its arguments: nothing that happened before, and nobody who looks, changes a bit of it.
#include "renderer/base/random.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class Frames : public GlTest {};

// Settings that differ in every attachment, in method, lights, camera and size.
std::vector<Settings> different_settings() {
  std::vector<Settings> all(5, settings_for(yard(), {64, 36}));
  all[1].layout = Layout::nclgl;
  all[1].normal.encoding = NormalEncoding::xyz8;
  all[1].depth.format = DepthFormat::d24;
  all[1].accumulation = {AccumulationFormat::rgba16f, AccumulationTargets::one};
  all[1].lights.method = LightMethod::fullscreen;
  all[1].lights.count = 5;
  all[1].camera.position.x = 8;
  all[1].ambient = 0.05;
  all[1].shading.exponent = 33;
  all[2].size = {51, 40};
  all[2].normal.encoding = NormalEncoding::oct8;
  all[2].depth.format = DepthFormat::d16;
  all[2].position.reconstruct = PositionReconstruct::inverse_viewproj;
  all[2].accumulation.format = AccumulationFormat::r11g11b10f;
  all[2].lights.method = LightMethod::fullscreen_radius;
  all[2].lights.seed = 9;
  all[2].colour = Colour::as_tutorial;
  all[2].time_s = 5;
  all[3].lights.method = LightMethod::volumes_stencil;
  all[3].accumulation.targets = AccumulationTargets::one;
  all[4].depth.format = DepthFormat::d24;
  all[4].lights.method = LightMethod::volumes_instanced;
  all[4].lights.cull = LightCull::front;
  all[4].lights.volume.depth = VolumeDepth::greater_equal;
  // Methods that keep more from one pass to the next than textures: lists, images, a choice.
  for (const LightMethod method : {LightMethod::clustered, LightMethod::tiled, LightMethod::auto_}) {
    Settings s = all[all.size() % 3];
    s.lights.method = method;
    s.lights.count = 40;
    if (gl::device().features.has(row(method).needs)) all.push_back(s);
  }
  return all;
}

using Stored = std::vector<std::vector<uint8_t>>;

// Drawn by a renderer that has drawn nothing else.
std::vector<Stored> separate_runs(const std::vector<Settings>& all) {
  std::vector<Stored> out;
  for (const Settings& s : all) {
    Stage stage(yard());
    stage.draw(s);
    out.push_back(stored(stage.targets));
  }
  return out;
}

TEST_F(Frames, EqualSettingsGiveEqualBits) {
  Stage stage(yard());
  for (const Settings& s : different_settings()) {
    stage.draw(s);
    const Stored first = stored(stage.targets);
    for (int again = 0; again < 3; ++again) {
      stage.draw(s);
      EXPECT_TRUE(stored(stage.targets) == first);
    }
  }
}

TEST_F(Frames, InterleavedSettingsGiveTheBitsOfSeparateRuns) {
  const std::vector<Settings> all = different_settings();
  const std::vector<Stored> expected = separate_runs(all);
  ASSERT_EQ(expected[0].size(), 6u);  // material, normal, depth, two light sums, lit
  Stage shared(yard());               // one renderer; each settings with targets of its own, and all in one
  std::vector<Targets> own(all.size());
  for (int round = 0; round < 2; ++round)
    for (size_t k = 0; k < all.size(); ++k) {
      shared.renderer.render(all[k], yard(), own[k]);
      shared.draw(all[k]);
      EXPECT_TRUE(stored(shared.targets) == expected[k]) << "shared targets, settings " << k;
    }
  for (size_t k = 0; k < all.size(); ++k) EXPECT_TRUE(stored(own[k]) == expected[k]) << "own targets, settings " << k;
}

// Views and counts of one frame while another was drawn in between: each looks at its own.
TEST_F(Frames, ViewsAndCountsBelongToTheirTargets) {
  const std::vector<Settings> all = different_settings();
  Stage a(yard()), b(yard());
  const PairCounts pairs = a.pairs(all[0]);
  const Image final = a.view(View::final, all[0], {.overlays = true}), count = a.view(View::lights_per_pixel, all[0]);
  FrameReport report = a.draw(all[0]);
  b.draw(all[2]);
  a.renderer.render(all[1], yard(), b.targets);  // the same renderer, other targets
  EXPECT_TRUE(a.view(View::final, all[0], {.overlays = true}) == final);
  a.renderer.count_pairs(all[0], yard(), a.targets, true);
  a.renderer.collect(a.targets, report, true);
  EXPECT_EQ(report.pairs->shaded, pairs.shaded);
  EXPECT_EQ(report.pairs->lit, pairs.lit);
  EXPECT_TRUE(a.view(View::lights_per_pixel, all[0]) == count);
}

// The number of lights at a pixel is counted for the frame that is probed, not left over from another.
TEST_F(Frames, AProbeSpeaksOfTheFrameJustDrawn) {
  Stage stage(yard());
  Settings s = settings_for(yard(), {64, 36});
  const auto lights_at_middle = [&] {
    stage.draw(s);
    stage.renderer.start_probe(s, yard(), stage.targets, {32, 30});
    return stage.renderer.take_probe(stage.targets, true)->number(ProbeField::lights);
  };
  s.lights.count = 4;
  const float four = lights_at_middle();
  EXPECT_GT(four, 0);
  s.lights.count = 0;
  EXPECT_EQ(lights_at_middle(), 0);
  s.lights.count = 4;
  EXPECT_EQ(lights_at_middle(), four);
  stage.renderer.start_probe(s, yard(), stage.targets, {32, 30});
  s.lights.count = 0;
  stage.draw(s);
  EXPECT_FALSE(stage.renderer.take_probe(stage.targets, true)) << "an answer of the frame before";
}

TEST_F(Frames, LookingChangesNothing) {
  Stage stage(yard());
  for (Settings s : different_settings()) {
    stage.draw(s);
    const Stored before = stored(stage.targets);
    s.view.volumes = VolumeOverlay::all;
    for (const View v : frame_views())
      for (const bool raw : {false, true})
        if (why_missing(v, s).empty()) stage.view(v, s, {.raw = raw, .overlays = true});
    stage.renderer.count_pairs(s, yard(), stage.targets, true);
    stage.renderer.start_probe(s, yard(), stage.targets, {5, 5});
    stage.renderer.take_probe(stage.targets, true);
    EXPECT_TRUE(stored(stage.targets) == before);
  }
}

// Everything of GL 3.3 that could leak into a frame, set to what hurts most.
void scramble_state() {
  for (const GLenum what : {GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE, GL_COLOR_LOGIC_OP,
                            GL_POLYGON_OFFSET_FILL, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_FRAMEBUFFER_SRGB, GL_DEPTH_CLAMP,
                            GL_RASTERIZER_DISCARD, GL_PRIMITIVE_RESTART, GL_DITHER, GL_SAMPLE_COVERAGE})
    glEnable(what);
  glScissor(0, 0, 1, 1), glViewport(5, 3, 2, 2), glDepthRange(0.9, 0.2);
  glStencilFunc(GL_NEVER, 1, 0xff), glStencilOp(GL_INVERT, GL_INVERT, GL_INVERT), glStencilMask(0),
      glDepthFunc(GL_NEVER), glDepthMask(GL_FALSE);
  glBlendFunc(GL_ZERO, GL_ZERO), glBlendEquation(GL_MIN), glColorMask(0, 1, 0, 0), glLogicOp(GL_CLEAR);
  glCullFace(GL_FRONT_AND_BACK), glFrontFace(GL_CW), glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
  glPolygonOffset(1e3f, 1e3f), glPrimitiveRestartIndex(1), glClampColor(GL_CLAMP_READ_COLOR, GL_TRUE);
  for (const GLenum what : {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS, GL_PACK_ROW_LENGTH,
                            GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS})
    glPixelStorei(what, 3);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 8), glPixelStorei(GL_PACK_ALIGNMENT, 8);
  glPixelStorei(GL_UNPACK_SWAP_BYTES, GL_TRUE), glPixelStorei(GL_PACK_SWAP_BYTES, GL_TRUE);
  glBindFramebuffer(GL_FRAMEBUFFER, 0), glUseProgram(0), glBindVertexArray(0), glBindBuffer(GL_ARRAY_BUFFER, 0);
}

constexpr GLuint kUnits = 48;  // no GL 3.3 has fewer

// A sampler object and a wrong texture at every unit, buffers where pixels are taken from and put to.
struct Intruders {
  GLuint sampler = 0, texture = 0, buffers[2] = {};
  Intruders() {
    glGenSamplers(1, &sampler), glGenTextures(1, &texture), glGenBuffers(2, buffers);
    glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glBindTexture(GL_TEXTURE_2D, texture);
    for (GLuint unit = 0; unit < kUnits; ++unit) {
      glActiveTexture(GL_TEXTURE0 + unit);
      glBindTexture(GL_TEXTURE_2D, texture), glBindSampler(unit, sampler);
    }
    for (int k = 0; k < 2; ++k) {
      const GLenum target = k ? GL_PIXEL_PACK_BUFFER : GL_PIXEL_UNPACK_BUFFER;
      glBindBuffer(target, buffers[k]);
      glBufferData(target, 1 << 20, nullptr, GL_STATIC_DRAW);
    }
  }
  ~Intruders() {
    for (GLuint unit = 0; unit < kUnits; ++unit) glBindSampler(unit, 0);
    glDeleteSamplers(1, &sampler), glDeleteTextures(1, &texture), glDeleteBuffers(2, buffers);
    scramble_state();
  }
};

TEST_F(Frames, StateLeftByOthersDoesNotLeakIn) {
  for (Settings s : different_settings()) {
    s.view.volumes = VolumeOverlay::all;
    Stage clean(yard());
    const PairCounts pairs = clean.pairs(s);
    const Stored expected = stored(clean.targets);
    const Image picture = clean.view(View::final, s, {.overlays = true});
    const GpuScene scene(std::make_shared<const Scene>(make_yard()));  // uploads, too
    Stage stage(scene);
    const Intruders intruders;
    scramble_state();
    FrameReport report = stage.draw(s);
    scramble_state();
    stage.renderer.count_pairs(s, scene, stage.targets, true);
    scramble_state();
    stage.renderer.collect(stage.targets, report, true);
    EXPECT_EQ(report.pairs->shaded, pairs.shaded);
    EXPECT_EQ(report.pairs->lit, pairs.lit);
    scramble_state();
    EXPECT_TRUE(stage.view(View::final, s, {.overlays = true}) == picture);
    gl::read_rgba32f(*stage.targets.frame.texture(Stores::lit));  // leaves pixel storage as stored() needs it
    EXPECT_TRUE(stored(stage.targets) == expected);
  }
}

int differing_texels(const Image& a, const Image& b) {
  int n = 0;
  for (size_t i = 0; i < a.rgba.size(); i += 4) n += !std::equal(&a.rgba[i], &a.rgba[i] + 4, &b.rgba[i]);
  return n;
}

// What is looked at has no part in a resolved frame, and changes the wires all the same.
TEST_F(Frames, WiresAreThoseOfThePickedLightOrOfAll) {
  Stage& stage = shared_stage(yard());
  Settings s = settings_for(yard());
  s.lights.count = 9;
  stage.draw(s);
  const auto shown = [&](VolumeOverlay volumes, int pick) {
    s.view.volumes = volumes;
    s.view.pick = pick;
    return stage.view(View::final, s, {.overlays = true});
  };
  const Image off = shown(VolumeOverlay::off, 0), all = shown(VolumeOverlay::all, 0);
  const Image first = shown(VolumeOverlay::picked, 0), fifth = shown(VolumeOverlay::picked, 4);
  EXPECT_GT(differing_texels(first, off), 0);
  EXPECT_GT(differing_texels(first, fifth), 0);
  EXPECT_LT(2 * differing_texels(fifth, off), differing_texels(all, off));
}

TEST_F(Frames, AFrameAndAllThatIsAskedOfItAreResolvedOnce) {
  Stage stage(yard());
  const Settings s = settings_for(yard());
  stage.pairs(s);
  for (const View v : {View::final, View::normal, View::lights_per_pixel}) stage.view(v, s, {.overlays = true});
  stage.renderer.start_probe(s, yard(), stage.targets, {3, 3});
  stage.renderer.take_probe(stage.targets, true);
  EXPECT_EQ(stage.renderer.resolver().resolved(), 1);
}

}  // namespace
}  // namespace gbl::test
