#pragma once
#include <csignal>
#include <gtest/gtest.h>
#include <sys/resource.h>

namespace gbl {

// While it lives, no file of this process and of those that it starts grows beyond so many bytes: a full disk.
class DiskRoom {
 public:
  explicit DiskRoom(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    EXPECT_EQ(getrlimit(RLIMIT_FSIZE, &before_), 0);
    rlimit tight = before_;
    tight.rlim_cur = bytes;
    EXPECT_EQ(setrlimit(RLIMIT_FSIZE, &tight), 0);
  }
  ~DiskRoom() {
    EXPECT_EQ(setrlimit(RLIMIT_FSIZE, &before_), 0);
    std::signal(SIGXFSZ, handler_);
  }
  DiskRoom(const DiskRoom&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

}  // namespace gbl
