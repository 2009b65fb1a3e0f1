// A statement that a broken renderer can pass says nothing. Each shader is broken on purpose, and the sweep that is about it
// must not hold.
#include "app/stability_bench.h"
#include "tests/gl_fixture.h"
#include "tests/shader_copy.h"

namespace gbl::test {
namespace {

struct Mutant {
  const char* name;
  const char* sweep;  // that names it
  const char* shader;
  const char* old;
  const char* by;
  const char* curve = "";  // that must be among those that no longer hold; empty: any
};

// Of reversed depth this is the whole of the error. Of standard depth it is a quarter more than the driver's own
// interpolation of depth, which no bound of a position can tell apart: `depth-decode` does.
constexpr const char* kCancelling = "return planes.z / (planes.y - (1.0 - depth_from_far(depth)) * planes.w);";
constexpr const char* kDepthFormula = "return planes.z / (planes.x + depth_from_far(depth) * planes.w);";

const Mutant kMutants[] = {
    {"ADepthFormulaThatCancels", "view-distance", "shaders/position.glsl", kDepthFormula, kCancelling},
    {"AStandardDepthFormulaThatCancels", "depth-decode", "shaders/position.glsl", kDepthFormula, kCancelling,
     "depth/d32f/view-ray"},
    {"ADepthFormulaThatCancelsNearby", "near-plane", "shaders/position.glsl", kDepthFormula, kCancelling},
    {"ACameraThatIsRounded", "world-offset", "shaders/position.glsl", "return range * (ray_forward.xyz + sideways);",
     "return range * (ray_forward.xyz + sideways) + 1e-7 * camera_position.xyz;"},
    {"ADroppedMeshMargin", "near-corner", "shaders/light_volume.vert", "inside_the_mesh ? proxy_reach(l) : l.range",
     "l.range"},
    {"AForgottenNearPlane", "near-corner", "shaders/light_volume.vert", "< reach + inside_margin", "< reach"},
    {"VolumesThatPlanesCut", "far-plane", "shaders/light_volume.vert", "position.z = 0.5 * position.w;",
     "position.z = position.z;"},
    {"AMeshInsideItsSphere", "volume-level", "shaders/volume_mesh.glsl", "vertex * ((range + slack) * scale)",
     "vertex * (range + slack)"},
    {"AMeshThatIsTooSmall", "light-distance", "shaders/volume_mesh.glsl", "vertex * ((range + slack) * scale)",
     "vertex * ((range + slack) * scale * real(0.8))"},
    {"AMeshThatIsTooSmallAnywhere", "cull-families", "shaders/volume_mesh.glsl", "vertex * ((range + slack) * scale)",
     "vertex * ((range + slack) * scale * real(0.8))"},
    {"AnUnfoldedOctahedron", "normal-angle", "shaders/normal_octahedral.glsl",
     "real fy = (real(1.0) - abs(x)) * sign_not_zero(y);", "real fy = real(1.0) - abs(x);"},
    {"ACappedExponent", "roughness", "shaders/pair.glsl", "exp2(exponent * log2(max(cosine, real(1e-37))))",
     "exp2(min(exponent, real(250.0)) * log2(max(cosine, real(1e-37))))"},
    {"LightThatIsRoundedBeforeItIsSummed", "light-count", "shaders/light_output.glsl",
     "sums.light.diffuse += one.diffuse;", "sums.light.diffuse += floor(one.diffuse * 255.0 + 0.5) / 255.0;"},
    {"LightsThatDoNotEnd", "range-threshold", "shaders/shade.glsl", "if_less(way.d, light.range, share)",
     "if_less(way.d, 4.0 * light.range, share)"},
};

std::ostream& operator<<(std::ostream& out, const Mutant& m) { return out << m.name; }

class StabilityMutants : public GlTest, public testing::WithParamInterface<Mutant> {};

SweepResult run(const char* id) {
  Renderer renderer;
  StabilityBench bench(renderer, gl::probe_device({}));
  const std::atomic<bool> never{false};
  const auto measure = [&](const SweepSetup& setup) { return bench.measure(setup); };
  return run_sweep(sweep(id), {.limits = bench.limits(), .rounding = bench.rounding()}, measure, nullptr, never);
}

TEST_P(StabilityMutants, IsNamedByItsSweep) {
  const Mutant& m = GetParam();
  ShaderCopy shaders;
  shaders.replace(m.shader, m.old, m.by);
  std::string named;
  for (const CurveResult& c : run(m.sweep).curves)
    for (const Judged& j : c.judged)
      if (!j.verdict.holds) named += fmt::format("{}: {}\n", c.curve, j.verdict.where);
  gl::take_misuse();  // a broken shader may have no use for what is set
  EXPECT_NE(named.find(m.curve), std::string::npos) << named;
  EXPECT_NE(named, "") << m.sweep << " holds although " << m.shader << " is broken";
}

INSTANTIATE_TEST_SUITE_P(Shaders, StabilityMutants, testing::ValuesIn(kMutants),
                         [](const testing::TestParamInfo<Mutant>& i) { return std::string(i.param.name); });

}  // namespace
}  // namespace gbl::test
