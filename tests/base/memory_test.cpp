#include "renderer/base/memory.h"

#include <gtest/gtest.h>
#include <memory>
#include <vector>

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
