// How much memory a large model takes, from the file to the picture and to the reference.
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "tests/gltf/gltf_fixture.h"
#include "tests/test_paths.h"
#include "tests/test_support.h"

namespace gbl::test {
namespace {

// A level grid with positions, normals and 32-bit indices, and nothing else.
Bytes grid(uint32_t side) {
  GltfFile file;
  std::vector<float> positions, normals;
  std::vector<uint32_t> indices;
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x) {
      positions.insert(positions.end(), {float(x) / side, 0, float(y) / side});
      normals.insert(normals.end(), {0, 1, 0});
    }
  for (uint32_t y = 0; y + 1 < side; ++y)
    for (uint32_t x = 0; x + 1 < side; ++x) {
      const uint32_t a = y * side + x;
      indices.insert(indices.end(), {a, a + side, a + 1, a + 1, a + side, a + side + 1});
    }
  const int position = file.numbers(positions, "VEC3"), normal = file.numbers(normals, "VEC3");
  json primitive = {{"attributes", {{"POSITION", position}, {"NORMAL", normal}}}};
  primitive["indices"] = file.numbers(indices, "SCALAR");
  file.place(primitive);
  return file.glb();
}

// Of the largest child so far.
double peak_mb() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return double(usage.ru_maxrss) * 1024 / 1e6;
}

TEST(Memory, AModelTakesFourTimesItsFileAndTheProgram) {
  const TemporaryFolder folder("memory");
  const Bytes bytes = grid(1000);  // 2 million triangles, 48 MB
  const std::filesystem::path file = folder / "grid.glb";
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  const double bound = 4 * double(bytes.size()) / 1e6 + 200;
  // The reference sends the corners to the driver again, in parts; how many of them it holds at once is its choice.
  const std::pair<const char*, double> views[] = {{"final", bound}, {"reference", bound + 80}};
  for (const auto& [view, most] : views) {
    const std::string command =
        fmt::format("'{}' render --scene '{}' --size 64x36 --only {} -o '{}' > /dev/null 2>&1",
                    (build_folder() / "gbufferlab").string(), file.string(), view, (folder / "out").string());
    ASSERT_EQ(std::system(command.c_str()), 0) << view;
    EXPECT_LE(peak_mb(), most) << view;
    EXPECT_GT(peak_mb(), double(bytes.size()) / 1e6) << "the measure measures";
  }
}

}  // namespace
}  // namespace gbl::test
