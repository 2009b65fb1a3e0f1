// One pixel explained: the lights that reach it, how often each was shaded, and the sum, against the frame and the truth.
#include <numeric>

#include "app/lab.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class PixelAccounts : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    lab_ = std::make_unique<Lab>(FeatureSet{});
  }
  PixelAccount account(const Settings& s, glm::ivec2 pixel) {
    lab_->show("yard", std::make_shared<const Scene>(make_yard()));
    lab_->draw(s);
    lab_->start_probe(pixel);
    const PixelProbe probe = lab_->take_probe(true).value();
    PixelAccount a = lab_->account(probe, true).value();
    count_lights(*lab_, a, 1000);
    return a;
  }
  static Settings settings() {
    Settings s = settings_for(yard(), {64, 36});
    s.scene = "yard";
    s.accumulation.targets = AccumulationTargets::split;
    s.accumulation.format = AccumulationFormat::rgba32f;
    s.normal.encoding = NormalEncoding::xyz32f;
    s.layout = Layout::float32;
    s.depth.format = DepthFormat::d32f_reversed;
    return s;
  }
  std::unique_ptr<Lab> lab_;
};

constexpr glm::ivec2 kSurface{32, 30};

const AccountLine& line(const std::vector<AccountLine>& lines, std::string_view what) {
  for (const AccountLine& l : lines)
    if (l.what == what) return l;
  ADD_FAILURE() << "no line " << what;
  return lines.front();
}

// A hidden light adds nothing, and the truth of the account is the reference's.
TEST_F(PixelAccounts, LightsBehindSomethingAreHidden) {
  Settings s = settings();
  s.lights.range_scale = 3;
  s.shadows = Shadows::all;
  int hidden = 0;
  for (int y = s.size.y / 8; y < s.size.y; y += s.size.y / 8)
    for (int x = s.size.x / 8; x < s.size.x; x += s.size.x / 8) {
      const PixelAccount a = account(s, {x, y});
      if (!a.surface) continue;
      glm::dvec3 all(0);
      for (const LightShare& l : a.lights) {
        all += l.diffuse + l.specular;
        if (!l.hidden) continue;
        ++hidden;
        EXPECT_EQ(l.arriving, 0);
        EXPECT_EQ(l.diffuse + l.specular, glm::dvec3(0));
        EXPECT_EQ(l.share, 0);
      }
      const std::vector<double>& lit = line(a.terms, "= lit").truth;
      const std::vector<double>& own = line(a.terms, "+ ambient, emission").truth;
      for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(lit[k], own[k] + all[static_cast<glm::length_t>(k)], 1e-12);
    }
  EXPECT_GT(hidden, 0);
}

// A pixel of the room's wall mirror: what it shows is a term of its own, and the terms are the sum.
TEST_F(PixelAccounts, WhatAMirrorShowsIsATerm) {
  const auto room = std::make_shared<const Scene>(build_room());
  Settings s = settings();
  s.scene = "builtin:room";
  s.size = {96, 54};
  s.camera = room->camera;
  s.lights.source = LightSource::scene;
  s.shading.model = ShadingModel::ggx;
  s.attenuation = Attenuation::windowed;
  s.reflections = Reflections::on;
  lab_->show(s.scene, room);
  lab_->draw(s);
  lab_->start_probe({8, 30});
  const PixelAccount a = lab_->account(lab_->take_probe(true).value(), true).value();
  ASSERT_EQ(room->instances[static_cast<size_t>(a.seen.object - 1)].name, "mirror");
  const AccountLine& mirrored = line(a.terms, "+ mirrored, refracted");
  EXPECT_GT(mirrored.truth[0], 0.02);
  // Right to the pixel, but for the mipmap of the wood that it shows: a driver may estimate which (llvmpipe does).
  EXPECT_LT(mirrored.error, 0.1 * mirrored.truth[0]);
  for (size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(line(a.terms, "= lit").truth[k],
                line(a.terms, "albedo x diffuse light").truth[k] + line(a.terms, "+ specular light").truth[k] +
                    line(a.terms, "+ ambient, emission").truth[k] + mirrored.truth[k],
                1e-12);
}

TEST_F(PixelAccounts, TheTermsAddUpToThePixelAndTheLightsToTheTerms) {
  Settings s = settings();
  s.lights.range_scale = 3;
  const PixelAccount a = account(s, kSurface);
  ASSERT_TRUE(a.surface);
  ASSERT_GE(a.lights.size(), 2u);
  EXPECT_FALSE(a.tie);
  EXPECT_EQ(a.first_off, -1) << a.terms[size_t(std::max(a.first_off, 0))].what;
  double share = 0;
  glm::dvec3 diffuse(0), specular(0);
  for (size_t i = 0; i < a.lights.size(); ++i) {
    const LightShare& l = a.lights[i];
    share += l.share, diffuse += l.diffuse, specular += l.specular;
    EXPECT_LT(l.distance, l.range);
    EXPECT_EQ(l.shaded, 1) << l.index;
    EXPECT_EQ(verdict_of(l), "");
    EXPECT_LE(l.share, a.lights[i > 0 ? i - 1 : 0].share);
  }
  EXPECT_NEAR(share, 1, 1e-12);
  for (int k = 0; k < 3; ++k) {
    const auto c = static_cast<size_t>(k);
    const auto truth = [&](const char* what) { return line(a.terms, what).truth[c]; };
    EXPECT_NEAR(truth("albedo x diffuse light"), diffuse[k], 1e-12);
    EXPECT_NEAR(truth("+ specular light"), specular[k], 1e-12);
    EXPECT_NEAR(truth("= lit"),
                truth("albedo x diffuse light") + truth("+ specular light") + truth("+ ambient, emission"), 1e-12);
  }
  // What is drawn in floats: shading of some lights, 1e-5 of what adds up.
  for (const AccountLine& l : a.terms) EXPECT_LE(l.error, 1e-4 * (1 + std::abs(l.truth[0]))) << l.what;
  EXPECT_LE(line(a.stored, "normal").error, 1e-3);
}

// Culling the back faces loses the lights that the camera stands in; culling none counts those twice that it sees from
// outside.
TEST_F(PixelAccounts, NamesTheLightsThatAMethodMissesOrCountsTwice) {
  Settings s = settings();
  s.lights.method = LightMethod::volumes;
  s.lights.volume.clip = VolumeClip::none;
  int missed = 0, doubled = 0;
  for (const LightCull cull : {LightCull::back, LightCull::none}) {
    s.lights.cull = cull;
    s.lights.range_scale = cull == LightCull::back ? 20 : 1;
    for (const glm::ivec2 pixel : {kSurface, glm::ivec2(10, 32), glm::ivec2(50, 33)}) {
      const PixelAccount a = account(s, pixel);
      for (const LightShare& l : a.lights) {
        missed += verdict_of(l) == "missed";
        doubled += verdict_of(l) == "counted twice";
        EXPECT_TRUE(cull == LightCull::none || l.shaded != 2);
      }
      const bool wrong = std::any_of(a.lights.begin(), a.lights.end(),
                                     [](const LightShare& l) { return !verdict_of(l).empty() && l.share > 0.1; });
      EXPECT_TRUE(!wrong || std::string_view(a.terms.at(size_t(a.first_off)).what) == "diffuse light");
    }
  }
  EXPECT_GT(missed, 0);
  EXPECT_GT(doubled, 0);
}

// It shades surfaces, hidden ones too: how often says nothing of the pixel.
TEST_F(PixelAccounts, ForwardShadingIsNotCounted) {
  Settings s = settings();
  s.lights.method = LightMethod::forward;
  s.lights.range_scale = 3;
  const PixelAccount a = account(s, kSurface);
  ASSERT_FALSE(a.lights.empty());
  for (const LightShare& l : a.lights) {
    EXPECT_FALSE(l.shaded);
    EXPECT_EQ(verdict_of(l), "");
  }
  EXPECT_EQ(a.first_off, -1);
}

// Numbers of a few pixels, and statistics of all, share a canvas: each answer has the size that was asked.
TEST_F(PixelAccounts, NumbersKeepTheSizeThatWasAskedFor) {
  lab_->show("yard", std::make_shared<const Scene>(make_yard()));
  lab_->draw(settings());
  const std::vector<glm::vec4> all = lab_->numbers_of(View::normal);
  lab_->ask_numbers(View::normal, {{3, 4}, {1, 1}, {5, 2}});
  lab_->ask_stats(View::normal);
  std::optional<std::vector<glm::vec4>> numbers;
  for (int k = 0; k < 1000 && !numbers; ++k) {
    glFinish();
    numbers = lab_->take_numbers();
  }
  ASSERT_TRUE(numbers);
  ASSERT_EQ(numbers->size(), 10u);
  for (size_t i = 0; i < 10; ++i) EXPECT_EQ((*numbers)[i], all[(4 + i / 5) * 64 + 3 + i % 5]) << i;
}

// Counting lights one by one leaves the frame as it was.
TEST_F(PixelAccounts, TheFrameStaysAsItWas) {
  const Settings s = settings();
  account(s, kSurface);
  lab_->draw_view(View::lights_per_pixel);
  const Image after = lab_->image_of(View::lights_per_pixel);
  lab_->draw(s);
  lab_->draw_view(View::lights_per_pixel);
  EXPECT_TRUE(after == lab_->image_of(View::lights_per_pixel));
}

TEST_F(PixelAccounts, TheBackgroundHasAResultAndNoLights) {
  Settings s = settings();
  s.camera.orientation = orientation_from_yaw_pitch(0, 80);
  const PixelAccount a = account(s, {5, 2});
  EXPECT_FALSE(a.surface);
  EXPECT_TRUE(a.lights.empty());
  EXPECT_EQ(a.first_off, -1);
  EXPECT_STREQ(a.terms.front().what, "= lit");
}

}  // namespace
}  // namespace gbl::test
