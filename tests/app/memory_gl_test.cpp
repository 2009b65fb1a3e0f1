// How much memory a large model takes, from the file to the picture and to the reference.
#include <cstdio>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/gltf/gltf_fixture.h"
#include "tests/sanitized.h"
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

// Does it in a process of its own; the most it ever held, MB. A child begins with the peak of who forks it, so this
// process must stay small, and what is large is made in another child.
template <class Work>
double peak_mb_of(Work work) {
  const pid_t child = fork();
  if (child == 0) {
    work();
    _exit(1);
  }
  int status = 0;
  rusage usage{};
  EXPECT_EQ(wait4(child, &status, 0, &usage), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  return double(usage.ru_maxrss) * 1024 / 1e6;
}

TEST(Memory, AModelTakesFourTimesItsFileAndTheProgram) {
  if (kSanitized) GTEST_SKIP() << "a sanitizer keeps what is freed";
  const TemporaryFolder folder("memory");
  const std::string file = (folder / "grid.glb").string(), out = (folder / "out").string(), gbufferlab = program();
  peak_mb_of([&] {
    const Bytes bytes = grid(1000);  // 2 million triangles, 48 MB
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    _exit(0);
  });
  const double file_mb = double(std::filesystem::file_size(file)) / 1e6, bound = 4 * file_mb + 200;
  // The reference sends the corners to the driver again, in parts; how many of them it holds at once is its choice.
  const std::pair<const char*, double> views[] = {{"final", bound}, {"reference", bound + 80}};
  for (const auto& [view, most] : views) {
    const double peak = peak_mb_of([&, &name = view] {
      // With threads llvmpipe bins the next 36 MiB of triangles while it draws the last, or does not, as it happens.
      setenv("LP_NUM_THREADS", "0", 1);
      if (!std::freopen("/dev/null", "w", stdout)) _exit(1);
      execl(gbufferlab.c_str(), "gbufferlab", "render", "--scene", file.c_str(), "--size", "64x36", "--only", name,
            "-o", out.c_str(), nullptr);
    });
    EXPECT_LE(peak, most) << view;
    EXPECT_GT(peak, file_mb) << "the measure measures";
  }
}

}  // namespace
}  // namespace gbl::test
