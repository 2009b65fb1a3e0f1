// Each part of the work is done once, and all of it before on_threads() is back.
#include "renderer/base/threads.h"

#include <atomic>
#include <gtest/gtest.h>
#include <new>
#include <vector>

namespace gbl {
namespace {

TEST(Threads, EachPartIsDoneOnceAndAllAreDoneAfterwards) {
  for (const int count : {1, 2, 3, 17}) {
    std::vector<std::atomic<int>> done(static_cast<size_t>(count));
    on_threads(count, [&](int i) { ++done[static_cast<size_t>(i)]; });
    for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1) << count;
  }
  EXPECT_GE(all_processors(), 1);
}

// Memory may run out on any of them.
TEST(Threads, WhatOneThrowsArrivesWhenAllHaveReturned) {
  for (int thrower = 0; thrower < 3; ++thrower) {
    std::atomic<int> done = 0;
    const auto work = [&](int i) {
      if (i == thrower) throw std::bad_alloc();
      ++done;
    };
    EXPECT_THROW(on_threads(3, work), std::bad_alloc) << thrower;
    EXPECT_EQ(done, 2) << thrower;
  }
}

}  // namespace
}  // namespace gbl
