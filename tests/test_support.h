#pragma once
// What several tests share: expected errors, directions, a folder that goes away.
#include <cmath>
#include <filesystem>
#include <glm/glm.hpp>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

#include "renderer/base/error.h"

namespace gbl {

// Runs an action that must throw an Error with this code, and gives its line.
template <class Action>
std::string error_line(ExitCode code, Action action) {
  try {
    action();
  } catch (const Error& e) {
    EXPECT_EQ(static_cast<int>(e.code()), static_cast<int>(code)) << e.what();
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
    return e.what();
  }
  ADD_FAILURE() << "no Error was thrown";
  return "";
}

inline bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

// n directions, each for an equal area of the unit sphere (Fibonacci lattice).
inline std::vector<glm::dvec3> fibonacci_sphere(int n) {
  constexpr double kTurn = 0.61803398874989485;  // golden ratio - 1
  std::vector<glm::dvec3> out;
  out.reserve(n);
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2.0 * i + 1) / n, r = std::sqrt(1 - z * z);
    const double angle = 2 * std::acos(-1.0) * (i * kTurn - std::floor(i * kTurn));
    out.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  return out;
}

// A folder of its own per process and name, removed at the end.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const std::string& name)
      : path_(std::filesystem::temp_directory_path() / ("gbl-" + name + "-" + std::to_string(getpid()))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace gbl
