#include "app/progress_line.h"

#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace gbl {
namespace {

constexpr double kSoonKnown = 2;  // seconds before it is said how long the rest takes

}  // namespace

std::string time_left(std::optional<double> seconds) {
  if (!seconds) return "";
  const long s = std::lround(*seconds);
  return s >= 120 ? fmt::format(", {} min left", (s + 30) / 60) : fmt::format(", {} s left", s);
}

ProgressLine::ProgressLine(size_t total)
    : total_(total), terminal_(isatty(STDERR_FILENO)), begun_(std::chrono::steady_clock::now()) {}

ProgressLine::~ProgressLine() {
  if (terminal_ && done_ > 0) fmt::print(stderr, "\r\033[K");
}

void ProgressLine::next(const std::string& what) {
  const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
  const bool known = done_ > 0 && spent > kSoonKnown;
  const std::string time = known ? time_left(spent / double(done_) * double(total_ - done_)) : "";
  ++done_;
  if (!terminal_) return;
  fmt::print(stderr, "\r\033[K{}/{}{}  {}", done_, total_, time, what);
  std::fflush(stderr);
}

}  // namespace gbl
