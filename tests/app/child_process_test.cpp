// This test's own program is the child: what it does there is a disabled test.
#include "app/child_process.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <thread>

namespace gbl {
namespace {

TEST(ChildProcess, DISABLED_Speaks) {
  fmt::print("said\n");
  fmt::print(stderr, "complained\n");
  std::fflush(stdout);
  std::_Exit(3);
}
TEST(ChildProcess, DISABLED_NeverEnds) {
  while (true) std::this_thread::sleep_for(std::chrono::seconds(1));
}
TEST(ChildProcess, DISABLED_Crashes) { std::raise(SIGKILL); }
TEST(ChildProcess, DISABLED_SaysALot) {
  for (int i = 0; i < 100'000; ++i) fmt::print("{:07}\n", i);
  std::fflush(stdout);
  std::_Exit(0);
}

ChildResult run(const char* test, double limit_s) {
  return run_child({fmt::format("--gtest_filter=ChildProcess.DISABLED_{}", test), "--gtest_also_run_disabled_tests"},
                   limit_s);
}

constexpr double kLong = 600;

TEST(ChildProcess, WhatItSaysAndItsExitCodeComeBack) {
  const ChildResult r = run("Speaks", kLong);
  EXPECT_EQ(r.exit_code, 3);
  EXPECT_EQ(r.signal, 0);
  EXPECT_FALSE(r.timed_out);
  EXPECT_NE(r.out.find("said\n"), std::string::npos);
  EXPECT_NE(r.err.find("complained\n"), std::string::npos);
}

TEST(ChildProcess, OneThatNeverEndsIsEnded) {
  const ChildResult r = run("NeverEnds", 0.5);
  EXPECT_TRUE(r.timed_out);
  EXPECT_EQ(r.signal, SIGKILL);
}

TEST(ChildProcess, ACrashIsToldFromATimeOut) {
  const ChildResult r = run("Crashes", kLong);
  EXPECT_FALSE(r.timed_out);
  EXPECT_EQ(r.signal, SIGKILL);
}

TEST(ChildProcess, ItMaySayMoreThanAPipeHolds) { EXPECT_GT(run("SaysALot", kLong).out.size(), 800'000u); }

}  // namespace
}  // namespace gbl
