#pragma once
// One load: whose file it is, what was noted on the way, how far it is.
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "renderer/gltf/scene_gltf.h"

namespace gbl::gltf {

// A part of the file that cannot be used. Caught where the part can be left out; the text completes "meshes[3]: …".
struct Broken : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Job {
 public:
  Job(std::string file, const LoadProgress* progress) : file_(std::move(file)), progress_(progress) {}

  const std::string& file() const { return file_; }
  void note(std::string line);            // a warning; equal lines are kept once
  std::vector<std::string> take_notes();  // the warnings, with a count of those beyond the limit
  [[noreturn]] void refuse(std::string_view what, std::string_view fix) const;  // Error(bad_input)
  [[noreturn]] void refuse_limit(std::string_view what, uint64_t found, uint64_t limit) const;
  void step(std::string_view stage, double fraction) const;  // reports; Error(interrupted) if cancelled
  bool cancelled() const { return progress_ && progress_->cancelled; }

 private:
  std::string file_;
  const LoadProgress* progress_;
  std::vector<std::string> notes_;
  std::unordered_set<std::string> known_;
  uint64_t unsaid_ = 0;
};

// For messages and labels: one line, no control characters, cut to kMaxNameLength at a whole character.
std::string clean_name(std::string_view);

}  // namespace gbl::gltf
