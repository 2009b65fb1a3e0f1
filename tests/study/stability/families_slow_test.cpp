// The sweep that shows most at once in its long form: every way to draw a light's volume in 600 random configurations.
#include "app/stability_bench.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class StabilityFamilies : public GlTest {};

TEST_F(StabilityFamilies, WhatIsStatedHoldsInTwoHundredConfigurationsOfEach) {
  Renderer renderer;
  StabilityBench bench(renderer, gl::probe_device({}));
  const std::atomic<bool> never{false};
  const auto measure = [&](const SweepSetup& setup) { return bench.measure(setup); };
  const SweepRun run{.values = family_values(200), .limits = bench.limits(), .rounding = bench.rounding()};
  for (const CurveResult& c : run_sweep(sweep("cull-families"), run, measure, nullptr, never).curves)
    for (const Judged& j : c.judged)
      EXPECT_TRUE(j.verdict.holds) << c.curve << " " << j.statement << ". But " << j.verdict.where;
}

}  // namespace
}  // namespace gbl::test
