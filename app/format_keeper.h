#pragma once
// Which formats this device has been found to store and read back as the tables say: each is checked before its first
// use, once per driver. What held is kept in a file, so that a start costs nothing; what did not is asked again.
#include <filesystem>
#include <set>
#include <string>

#include "renderer/passes/format_check.h"

namespace gbl {

std::filesystem::path format_file();  // in the state folder; empty where there is none

class FormatKeeper {
 public:
  // A file that cannot be read is as good as none; so is one that cannot be written.
  FormatKeeper(std::filesystem::path, const gl::Device&);

  // Checks what is new in these settings; what does not hold is said on the standard error.
  void check(const Settings& resolved);
  // A clause for each format that has not held so far, in this process.
  const std::vector<std::string>& doubts() const { return doubts_; }

 private:
  void keep() const;

  std::filesystem::path file_;
  std::string device_;  // driver and program: another of either is asked anew
  std::set<std::string> held_;
  std::set<std::string> failed_;
  std::vector<std::string> doubts_;
};

}  // namespace gbl
