// What is stated of every stability curve holds on this device.
#include "app/stability_bench.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class StabilityGl : public GlTest {};

StabilityBench& bench() {
  static const gl::Device device = gl::probe_device({});
  static Renderer renderer;
  static StabilityBench b(renderer, device);
  return b;
}

SweepResult run(const Sweep& s) {
  const std::atomic<bool> never{false};
  const SweepRun how{.limits = bench().limits(), .rounding = bench().rounding()};
  return run_sweep(
      s, how, [](const SweepSetup& setup) { return bench().measure(setup); }, nullptr, never);
}

void expect_holds(const char* id) {
  for (const CurveResult& c : run(sweep(id)).curves)
    for (const Judged& j : c.judged)
      EXPECT_TRUE(j.verdict.holds) << c.curve << " " << j.statement << ". But " << j.verdict.where;
}

TEST_F(StabilityGl, LightDistance) { expect_holds("light-distance"); }
TEST_F(StabilityGl, NearCorner) { expect_holds("near-corner"); }
TEST_F(StabilityGl, FarPlane) { expect_holds("far-plane"); }
TEST_F(StabilityGl, VolumeLevel) { expect_holds("volume-level"); }
TEST_F(StabilityGl, CullFamilies) { expect_holds("cull-families"); }
TEST_F(StabilityGl, NormalAngle) { expect_holds("normal-angle"); }
TEST_F(StabilityGl, Roughness) { expect_holds("roughness"); }
TEST_F(StabilityGl, SubPixelPan) { expect_holds("sub-pixel-pan"); }
TEST_F(StabilityGl, ViewDistance) { expect_holds("view-distance"); }
TEST_F(StabilityGl, WorldOffset) { expect_holds("world-offset"); }
TEST_F(StabilityGl, DepthDecode) { expect_holds("depth-decode"); }
TEST_F(StabilityGl, NearPlane) { expect_holds("near-plane"); }
TEST_F(StabilityGl, LightCount) { expect_holds("light-count"); }
TEST_F(StabilityGl, RangeThreshold) { expect_holds("range-threshold"); }
TEST_F(StabilityGl, ShadowBias) { expect_holds("shadow-bias"); }
TEST_F(StabilityGl, ParallaxSteps) { expect_holds("parallax-steps"); }
TEST_F(StabilityGl, ParallaxAngle) { expect_holds("parallax-angle"); }

// The tests above would pass without a judge: a wrong statement about a right curve is found out.
TEST_F(StabilityGl, AWrongStatementDoesNotHold) {
  Sweep s = sweep("far-plane");
  s.curves = [](const DeviceRounding& rounding) {
    std::vector<Curve> curves = sweep("far-plane").curves(rounding);
    curves[0].expected = {Flat{0}};  // front faces culled, clipped by the planes: it loses the light
    curves[1].expected = {Diverges{.up_to = 120, .from = 140, .holds = 0, .fails = 0.5}};
    return curves;
  };
  const SweepResult r = run(s);
  EXPECT_FALSE(r.curves[0].judged[0].verdict.holds);
  EXPECT_FALSE(r.curves[1].judged[0].verdict.holds);
  EXPECT_TRUE(r.curves[3].judged[0].verdict.holds);
  EXPECT_FALSE(r.holds());
}

// The same point twice is the same to the last bit, whatever was measured in between.
TEST_F(StabilityGl, APointIsTheSameWheneverItIsMeasured) {
  const Sweep& s = sweep("light-count");
  const Curve curve = s.curves(bench().rounding())[2];
  const auto at = [&](double x) { return *bench().measure(setup_at(s, curve, x)).errors.rmse_linear; };
  const double first = at(64), other = at(16);
  EXPECT_EQ(at(64), first);
  EXPECT_NE(other, first);
}

}  // namespace
}  // namespace gbl::test
