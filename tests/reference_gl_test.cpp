// The reference against the GPU: the float32 forward frame agrees with it but for float's own noise, and the counts of
// the GPU are the reference's.
#include <fmt/format.h>

#include "app/truth_keeper.h"
#include "renderer/scene_look.h"
#include "renderer/truth/measure.h"
#include "tests/gl_fixture.h"

namespace gbl::test {
namespace {

class ReferenceGl : public GlTest {
 protected:
  std::shared_ptr<const TruthSet> truth_of(const Settings& s, const GpuScene& scene) {
    TruthKeeper keeper(1, 2);
    return keeper.get(renderer, scene, s, true);
  }
  Renderer renderer;
  Targets targets;
};

double largest(const glm::dvec3& d) { return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}); }

TEST_F(ReferenceGl, TheWitnessAgreesInEveryScene) {
  for (const BuiltinScene& b : builtin_scenes()) {
    const std::string name = fmt::format("builtin:{}", b.id);
    const GpuScene scene(open_scene(name));
    for (const ShadingModel model : {ShadingModel::blinn_phong, ShadingModel::ggx}) {
      Settings s = preset("start").make();
      s.scene = name;
      apply_scene(s, name, scene.scene());
      s.shading.model = model;
      s.size = {160, 90};
      const auto set = truth_of(s, scene);
      std::vector<double> off;
      double worst = 0;
      int beyond = 0;
      size_t worst_at = 0;
      for (size_t i = 0; i < set->truth.pixels(); ++i) {
        const double scale = 1 + largest(set->truth.lit[i]);
        const double d = largest(glm::dvec3(set->witness_lit[i]) - set->truth.lit[i]) / scale;
        if (d > worst) worst = d, worst_at = i;
        off.push_back(d);
        beyond += d > 1e-4;
      }
      std::sort(off.begin(), off.end());
      fmt::print("{:<12} {:<12} median {:.2e} p99 {:.2e} p99.9 {:.2e} max {:.2e} at {},{} beyond {}\n", b.id, row(model).id, off[off.size() / 2],
                 off[off.size() * 99 / 100], off[off.size() * 999 / 1000], worst, worst_at % 160, worst_at / 160, beyond);
    }
  }
}

}  // namespace
}  // namespace gbl::test
