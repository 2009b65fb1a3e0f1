// The held pixel's position by each way to store it, against frames that are drawn that way.
#include "renderer/truth/position_routes.h"

#include "app/lab.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class PositionRoutes : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    lab_ = std::make_unique<Lab>(FeatureSet{});
    lab_->show("yard", std::make_shared<const Scene>(make_yard()));
  }
  static Settings settings() {
    Settings s = settings_for(yard(), {64, 36});
    s.scene = "yard";
    s.depth.format = DepthFormat::d24;
    return s;
  }
  PixelProbe probe(const Settings& s, glm::ivec2 pixel) {
    lab_->draw(s);
    lab_->start_probe(pixel);
    return lab_->take_probe(true).value();
  }
  PixelAccount account(const Settings& s, glm::ivec2 pixel) {
    const PixelProbe p = probe(s, pixel);
    return lab_->account(p, true).value();
  }
  std::unique_ptr<Lab> lab_;
};

constexpr glm::ivec2 kPixels[] = {{32, 30}, {10, 32}, {50, 33}};

// How far a frame may be from what is said of it: a step of what is stored, for a driver may cut it off where we round.
double step_of(const PositionRoute& r, const glm::dvec3& position, double distance) {
  const double largest = std::max({std::abs(position.x), std::abs(position.y), std::abs(position.z)});
  switch (r.source) {
    case PositionSource::world16f: return 2 * std::ldexp(largest, -10);
    case PositionSource::view16f: return 2 * std::ldexp(distance, -10);
    case PositionSource::view_scaled: return 2 * 1e6 * std::ldexp(1.0, -24);
    default: return 1e-5 * (distance + glm::length(position));
  }
}

TEST_F(PositionRoutes, AreWhatFramesReadThatAreDrawnThatWay) {
  for (const glm::ivec2 pixel : kPixels) {
    const PixelAccount a = account(settings(), pixel);
    ASSERT_TRUE(a.surface);
    ASSERT_EQ(a.routes.size(), rows<PositionReconstruct>().size() + rows<PositionSource>().size() - 1);
    for (const PositionRoute& r : a.routes) {
      Settings s = settings();
      s.position = {r.source, r.reconstruct};
      const glm::dvec3 drawn = probe(s, pixel).vector(ProbeField::position);
      EXPECT_LE(glm::distance(drawn, r.position), step_of(r, a.true_position, a.depth.distance)) << name_of(r);
      EXPECT_NEAR(r.error, glm::distance(r.position, a.true_position), 1e-12);
    }
  }
}

TEST_F(PositionRoutes, SayWhichIsUsedAndWhichAreUnsound) {
  Settings s = settings();
  for (const PositionSource source : {PositionSource::depth, PositionSource::view16f}) {
    s.position = {source, PositionReconstruct::inverse_viewproj_varying};
    std::string used;
    int unsound = 0;
    for (const PositionRoute& r : account(s, kPixels[0]).routes) {
      if (r.used) used += name_of(r);
      unsound += !pitfall_of(r).empty();
    }
    EXPECT_EQ(used, source == PositionSource::depth ? "depth, inverse-viewproj-varying" : "view16f");
    EXPECT_EQ(unsound, 1) << "the inverse per vertex";
  }
  s.lights.method = LightMethod::forward;
  EXPECT_TRUE(account(s, kPixels[0]).routes.empty()) << "forward shading reads none";
}

TEST_F(PositionRoutes, FineFormatsAreNearerThanCoarseOnes) {
  double half = 0, whole = 0;
  for (const glm::ivec2 pixel : kPixels)
    for (const PositionRoute& r : account(settings(), pixel).routes) {
      if (r.source == PositionSource::world16f) half += r.error;
      if (r.source == PositionSource::world32f) whole += r.error;
    }
  EXPECT_GT(half, 50 * whole);
}

TEST_F(PositionRoutes, DepthHasAllOfItsDigits) {
  Settings s = settings();
  for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f}) {
    s.depth.format = format;
    const PixelProbe p = probe(s, kPixels[0]);
    const DepthAccount d = lab_->account(p, true).value().depth;
    EXPECT_FLOAT_EQ(float(d.window), p.number(ProbeField::window_depth));
    EXPECT_EQ(d.floating, format == DepthFormat::d32f);
    EXPECT_GT(d.step, 0);
    // Within a step of the format, and of the rasteriser's own float.
    EXPECT_NEAR(d.distance, d.truth, 2 * d.step + 1e-4 * d.truth);
    EXPECT_NEAR(d.distance, p.number(ProbeField::range), 1e-5 * d.distance);
  }
  EXPECT_EQ(code_text({0x1f3a, 16, false, 0, 0, 0, 0}), "0x1f3a of 16 bits");
  EXPECT_EQ(code_text({0x1f3a, 24, false, 0, 0, 0, 0}), "0x001f3a of 24 bits");
}

}  // namespace
}  // namespace gbl::test
