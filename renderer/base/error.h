#pragma once
// The one exception of the lab: a bad file, setting, shader or context. Caught once in main() (exit code and
// one line) and once in the window (message shown, old picture kept). Programmer's mistakes are asserts.
#include <stdexcept>
#include <string>
#include <string_view>

namespace gbl {

enum class ExitCode { done = 0, check_failed = 1, bad_input = 2, no_gl = 3, unfinished = 4, interrupted = 130 };

// What a terminal shows of any bytes: UTF-8 as it is, "?" for bytes that are none, a blank for control characters; cut
// with "…" after so many bytes.
std::string printable(std::string_view text, size_t most);

class Error : public std::runtime_error {
 public:
  // where: file, option or place; what: what is wrong; fix: what to do about it. One line that is printable: "where: what; fix".
  Error(ExitCode code, std::string_view where, std::string_view what, std::string_view fix = {});
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

// "bakc" among {back, none, …} -> "did you mean 'back'? known: back, none, …"
std::string suggest(std::string_view given, const std::string_view* known, size_t count);
template <class Names>
std::string suggest(std::string_view given, const Names& known) {
  return suggest(given, known.data(), known.size());
}

}  // namespace gbl
