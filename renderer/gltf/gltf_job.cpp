#include "renderer/gltf/gltf_job.h"

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/gltf/gltf_limits.h"

namespace gbl::gltf {

void Job::note(std::string line) {
  if (known_.count(line)) return;
  if (notes_.size() >= kMaxWarnings) {
    ++unsaid_;
    return;
  }
  known_.insert(line);
  notes_.push_back(std::move(line));
}

std::vector<std::string> Job::take_notes() {
  if (unsaid_ > 0) notes_.push_back(fmt::format("and {} more", unsaid_));
  return std::move(notes_);
}

void Job::refuse(std::string_view what, std::string_view fix) const {
  throw Error(ExitCode::bad_input, file_, what, fix);
}

void Job::refuse_limit(std::string_view what, uint64_t found, uint64_t limit) const {
  refuse(fmt::format("{} {}, at most {} are read", found, what, limit), "split or simplify the model");
}

void Job::step(std::string_view stage, double fraction) const {
  if (!progress_) return;
  if (progress_->cancelled) throw Error(ExitCode::interrupted, file_, "loading was stopped");
  if (progress_->report) progress_->report(stage, fraction);
}

std::string clean_name(std::string_view name) {
  std::string clean;
  for (const char c : name.substr(0, kMaxNameLength)) {
    const auto byte = static_cast<unsigned char>(c);
    clean += byte < 0x20 || byte == 0x7f ? ' ' : c;
  }
  // UTF-8: continuation bytes are 10xxxxxx; a character that was cut loses its first bytes too.
  if (name.size() > kMaxNameLength && (static_cast<unsigned char>(name[kMaxNameLength]) & 0xc0) == 0x80) {
    while (!clean.empty() && (static_cast<unsigned char>(clean.back()) & 0xc0) == 0x80) clean.pop_back();
    if (!clean.empty()) clean.pop_back();
  }
  return clean;
}

}  // namespace gbl::gltf
