#pragma once
// How far a command is that does one thing after the other: on a terminal a line that is written over, else nothing.
#include <chrono>
#include <optional>
#include <string>

namespace gbl {

// ", 40 s left", ", 3 min left"; empty: not known.
std::string time_left(std::optional<double> seconds);

class ProgressLine {
 public:
  explicit ProgressLine(size_t total);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  void next(const std::string& what);  // about to be done

 private:
  size_t total_, done_ = 0;
  bool terminal_;
  std::chrono::steady_clock::time_point begun_;
};

}  // namespace gbl
