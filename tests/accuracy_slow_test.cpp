// What `compact` and `exact` promise, over every built-in scene and every model at hand, from each scene's own camera
// and four seeded ones.
#include <fmt/format.h>

#include "app/bench.h"
#include "renderer/scene_look.h"
#include "renderer/settings_json.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

TEST(Probe, Accuracy) {
  static const HeadlessContext context;
  gl::probe_device({});
  Renderer renderer;
  FrameCost cost(true);
  std::vector<std::string> names;
  for (const BuiltinScene& b : builtin_scenes()) names.push_back(fmt::format("builtin:{}", b.id));
  if (const char* only = getenv("SCENES")) {
    names.clear();
    std::istringstream in(only);
    for (std::string n; std::getline(in, n, ',');) names.push_back(n);
  }
  std::vector<std::string> sets;
  if (const char* x = getenv("SETS")) {
    std::istringstream in(x);
    for (std::string n; std::getline(in, n, ',');) sets.push_back(n);
  }
  const std::string presets = getenv("PRESETS") ? getenv("PRESETS") : "compact,exact";
  for (const std::string& name : names) {
    auto scene = std::make_shared<const GpuScene>(open_scene(name));
    Bench bench(renderer, cost, {}, 1);
    std::istringstream ps(presets);
    for (std::string p; std::getline(ps, p, ',');) {
      Settings s = preset(p).make();
      const Settings method = s;
      apply_scene(s, name, scene->scene());
      for (const Option& o : options())
        if (o.group == Group::method) o.set(s, o.get(method), o);
      s.size = {640, 360};
      s.lights.source = LightSource::generated;
      s.lights.count = 64, s.lights.seed = 1;
      s.shading.model = ShadingModel::ggx;
      s.attenuation = Attenuation::windowed;
      s.range.kind = RangeKind::source;
      s.colour = Colour::srgb;
      for (const std::string& x : sets) apply_assignment(s, x);
      bench.start(s, scene, {.times = false});
      bench.step(true);
      const BoundCheck one = bench.bound(1 / 255.0), half = bench.bound(0.5 / 255);
      fmt::print("{:<40} {:<8} {:>2} B {:<12} over1 {:.6f} ({} excused) half: {} over of {} ({} excused) worst {:.2f} codes at {},{}  nrm p99 {:.4f} pos max {:.4g}\n", name.substr(name.rfind('/') + 1), p,
                 bench.report().gbuffer_bytes_per_pixel, row(bench.report().drawn.layout).id, one.share_over(), one.excused, half.over, half.compared, half.excused, half.worst * 255, half.worst_pixel.x, half.worst_pixel.y,
                 bench.errors().normal_deg_p99.value_or(-1), bench.errors().position_max.value_or(-1));
      fflush(stdout);
      if (half.worst_pixel.x >= 0 && getenv("DEBUG")) {
        const size_t i = size_t(half.worst_pixel.y) * 640 + half.worst_pixel.x;
        const Truth& t = bench.truth()->truth;
        const auto v = [](auto a) { return fmt::format("({:.6g} {:.6g} {:.6g})", a.x, a.y, a.z); };
        fmt::print("   lit {} true {} witness {}\n   normal {} true {}\n   pos {} true {}\n   albedo {} rough {} diffuse {} spec {} unlit {}\n", v(bench.drawn().lit[i]), v(t.lit[i]),
                   v(bench.truth()->witness_lit[i]), v(bench.drawn().normal[i]), v(t.normal[i]), v(bench.drawn().position[i]), v(t.position[i]), v(t.albedo[i]), t.roughness[i], v(t.diffuse[i]), v(t.specular[i]), v(bench.drawn().unlit[i]));
      }
    }
  }
}

}  // namespace
}  // namespace gbl::test
