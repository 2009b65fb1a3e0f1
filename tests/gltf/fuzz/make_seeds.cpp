// make_seeds FOLDER: the fuzzer's first corpus, one small file per feature.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "tests/gltf/gltf_fixture.h"

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: make_seeds FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  std::filesystem::create_directories(folder);
  for (const gbl::test::Seed& seed : gbl::test::seeds()) {
    std::ofstream out(folder / seed.name, std::ios::binary);
    out.write(reinterpret_cast<const char*>(seed.bytes.data()), static_cast<std::streamsize>(seed.bytes.size()));
  }
}
