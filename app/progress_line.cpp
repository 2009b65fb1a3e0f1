#include "app/progress_line.h"

#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace gbl {
namespace {

constexpr double kSoonKnown = 2;  // seconds before it is said how long the rest takes

}  // namespace

ProgressLine::ProgressLine(size_t total)
    : total_(total), terminal_(isatty(STDERR_FILENO)), begun_(std::chrono::steady_clock::now()) {}

ProgressLine::~ProgressLine() {
  if (terminal_ && done_ > 0) fmt::print(stderr, "\r\033[K");
}

void ProgressLine::next(const std::string& what) {
  const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
  const double left = done_ > 0 ? spent / double(done_) * double(total_ - done_) : 0;
  const std::string time = done_ > 0 && spent > kSoonKnown ? fmt::format(", about {:.0f} s left", left) : "";
  ++done_;
  if (!terminal_) return;
  fmt::print(stderr, "\r\033[K{}/{}{}  {}", done_, total_, time, what);
  std::fflush(stderr);
}

}  // namespace gbl
