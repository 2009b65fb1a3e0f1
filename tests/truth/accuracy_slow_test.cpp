// The promises of `compact` and `exact` over every built-in scene and every model at hand, from the scene's own camera
// and four seeded ones.
#include <algorithm>

#include "tests/test_paths.h"
#include "tests/truth/accuracy.h"

namespace gbl::test {
namespace {

constexpr int kCameras = 5;

constexpr const char* kSmooth =
    "a smooth surface at the flank of a highlight ten times brighter than white: the 32-bit normal is not enough";
constexpr const char* kNear =
    "a light that all but touches the surface: float positions move its inverse square by a third of a code, the "
    "witness's too";
constexpr KnownExcess kBeyondHalfACode[] = {{"Box With Spaces.gltf", 2, 1, 0.6, kSmooth},
                                            {"NormalTangentTest.glb", 1, 1, 0.9, kSmooth},
                                            {"TextureSettingsTest.gltf", 2, 1, 0.6, kNear},
                                            {"TextureSettingsTest.gltf", 4, 1, 0.6, kNear}};

TEST_F(Accuracy, HoldsInEveryBuiltinScene) {
  for (const BuiltinScene& b : builtin_scenes()) expect_promises(fmt::format("builtin:{}", b.id), kCameras);
}

TEST_F(Accuracy, HoldsInEveryModel) {
  const std::filesystem::path models = test::source_folder() / ".." / "shared" / "models";
  if (!std::filesystem::exists(models)) GTEST_SKIP() << "no folder of models beside the project";
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(models))
    if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const std::string& file : files) expect_promises(file, kCameras, kBeyondHalfACode);
}

}  // namespace
}  // namespace gbl::test
