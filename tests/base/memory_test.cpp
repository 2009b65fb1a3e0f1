#include "renderer/base/memory.h"

#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <thread>
#include <vector>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "tests/sanitized.h"

namespace gbl {
namespace {

constexpr size_t kMiB = 1 << 20;

// Pictures and vertices come and go, and small blocks that stay lie between them.
TEST(Memory, WhatIsFreedGoesBackToTheSystem) {
  if (test::kSanitized) GTEST_SKIP() << "a sanitizer keeps what is freed";
  if (resident_bytes() == 0) GTEST_SKIP() << "this system does not say how much a process holds";
  return_freed_memory();
  { const std::vector<char> freed(24 * kMiB, 1); }  // from here on glibc would keep blocks of this size
  const uint64_t before = resident_bytes();
  std::vector<std::unique_ptr<std::vector<char>>> small;
  for (int round = 0; round < 4; ++round) {
    std::vector<std::vector<char>> large;
    for (int k = 0; k < 20; ++k) {
      large.emplace_back(12 * kMiB, 1);
      small.push_back(std::make_unique<std::vector<char>>(1000, 1));
    }
    EXPECT_GT(resident_bytes(), before + 200 * kMiB) << "the measure measures";
  }
  EXPECT_LT(resident_bytes(), before + 16 * kMiB);
}

TEST(Memory, ThreadsShareOneHeap) {
#ifdef __GLIBC__
  if (test::kSanitized) GTEST_SKIP() << "a sanitizer has heaps of its own";
  return_freed_memory();
  std::vector<std::unique_ptr<std::string>> kept(64);
  std::vector<std::thread> threads;
  for (auto& text : kept) threads.emplace_back([&] { text = std::make_unique<std::string>(1000, 'x'); });
  for (std::thread& t : threads) t.join();
  char* xml = nullptr;
  size_t size = 0;
  std::FILE* out = open_memstream(&xml, &size);
  malloc_info(0, out);
  std::fclose(out);
  const std::string said(xml, size);
  std::free(xml);
  EXPECT_NE(said.find("<heap nr=\"0\""), std::string::npos) << said;
  EXPECT_EQ(said.find("<heap nr=\"1\""), std::string::npos) << said;
#else
  GTEST_SKIP() << "only glibc has one for each thread";
#endif
}

// A few small blocks that stay keep what is free between them, until it is given back.
TEST(Memory, WhatIsFreeInsideOfTheHeapGoesBackWhenAsked) {
  if (test::kSanitized) GTEST_SKIP() << "a sanitizer keeps what is freed";
  if (resident_bytes() == 0) GTEST_SKIP() << "this system does not say how much a process holds";
  const uint64_t before = resident_bytes();
  std::vector<std::unique_ptr<std::vector<char>>> blocks(64 * 1024);
  for (auto& block : blocks) block = std::make_unique<std::vector<char>>(1000, 1);
  for (size_t k = 0; k < blocks.size(); ++k)
    if (k % 500 != 0) blocks[k].reset();
  EXPECT_GT(resident_bytes(), before + 48 * kMiB) << "the measure measures";
  return_free_pages();
  EXPECT_LT(resident_bytes(), before + 16 * kMiB);
}

}  // namespace
}  // namespace gbl
