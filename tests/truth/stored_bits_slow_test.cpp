// How many bits each channel of a material needs, asked in double: the reference with that channel alone rounded,
// against the reference. It is the study behind the layout `exact`: fewer bits do not do.
#include <fmt/format.h>

#include "app/truth_keeper.h"
#include "renderer/base/threads.h"
#include "renderer/gbuffer/normal_encoding.h"
#include "renderer/opening/scene_look.h"
#include "tests/test_paths.h"
#include "tests/truth/accuracy.h"

namespace gbl::test {
namespace {

double srgb_code(double c) { return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055; }
double linear_of(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

double rounded(double x, int bits) {
  const double levels = std::exp2(bits) - 1;
  return std::floor(std::clamp(x, 0.0, 1.0) * levels + 0.5) / levels;
}
glm::dvec3 coded(const glm::dvec3& c, int bits) {
  glm::dvec3 out;
  for (int k = 0; k < 3; ++k) out[k] = linear_of(rounded(srgb_code(std::clamp(c[k], 0.0, 1.0)), bits));
  return out;
}

struct Channel {
  const char* name;
  StoreFn store;
  bool enough;  // for half a code everywhere
};

std::vector<Channel> channels(double exposure) {
  const auto base = [](int bits) { return [=](TruthMaterial& m) { m.base = coded(m.base, bits); }; };
  const auto rough = [](int bits) { return [=](TruthMaterial& m) { m.roughness = rounded(m.roughness, bits); }; };
  const auto metal = [](int bits) { return [=](TruthMaterial& m) { m.metal = rounded(m.metal, bits); }; };
  const auto occlusion = [](int bits) { return [=](TruthMaterial& m) { m.occlusion = rounded(m.occlusion, bits); }; };
  const auto emission = [=](int bits) {
    return [=](TruthMaterial& m) { m.emission = coded(m.emission * exposure, bits) / exposure; };
  };
  const auto normal = [](NormalEncoding e) {
    return [=](TruthMaterial& m) { m.normal = glm::normalize(stored_normal(e, m.normal)); };
  };
  return {{"base colour 3 x 9", base(9), false},
          {"base colour 3 x 10", base(10), true},
          {"roughness 10", rough(10), false},
          {"roughness 12", rough(12), true},
          {"metal 6", metal(6), false},
          {"metal 8", metal(8), true},
          {"occlusion 6", occlusion(6), false},
          {"occlusion 8", occlusion(8), true},
          {"emission 3 x 7", emission(7), false},
          {"emission 3 x 9", emission(9), true},
          {"normal oct14, 28", normal(NormalEncoding::oct14), false},
          {"normal oct16, 32", normal(NormalEncoding::oct16), true}};
}

class StoredBits : public GlTest {};

// 320 x 180 from each scene's own camera, 64 lights, GGX.
TEST_F(StoredBits, FewerThanExactHasDoNotDo) {
  const std::filesystem::path models = test::source_folder() / ".." / "shared" / "models";
  if (!std::filesystem::exists(models))
    GTEST_SKIP() << "no folder of models beside the project: metal and occlusion textures are theirs";
  std::vector<std::string> names;
  for (const BuiltinScene& b : builtin_scenes()) names.push_back(fmt::format("builtin:{}", b.id));
  for (const auto& entry : std::filesystem::recursive_directory_iterator(models))
    if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb") names.push_back(entry.path());
  std::vector<double> worst(channels(1).size());
  std::vector<size_t> over(worst.size());
  Renderer renderer;
  for (const std::string& name : names) {
    const GpuScene scene(open_scene(name));
    Settings s = promised("exact", name, scene.scene(), 0);
    s.size = {320, 180};
    TruthKeeper keeper(1, all_processors());
    const auto set = keeper.get(renderer, scene, s, true);
    const std::vector<Channel> all = channels(s.exposure);
    for (size_t k = 0; k < all.size(); ++k) {
      Reference stored(s, scene.shared_scene(), set->texels, all[k].store);
      stored.run(all_processors());
      std::vector<glm::vec3> lit(stored.truth().lit.begin(), stored.truth().lit.end());
      const BoundCheck b = check_bound(set->truth, lit, {}, {s.exposure, s.colour}, kHalfCode);
      worst[k] = std::max(worst[k], 255 * b.worst);
      over[k] += b.over;
    }
  }
  const std::vector<Channel> all = channels(1);
  for (size_t k = 0; k < all.size(); ++k) {
    fmt::print("{:<20} worst {:.2f} codes, {} pixels beyond half a code\n", all[k].name, worst[k], over[k]);
    EXPECT_EQ(worst[k] <= 0.5, all[k].enough) << all[k].name;
  }
}

}  // namespace
}  // namespace gbl::test
