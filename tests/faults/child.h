#pragma once
// The program as a process of its own, which a test may kill or keep short of room: nothing it does harms the test.
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include "tests/test_paths.h"

namespace gbl::test {

struct Room {
  std::optional<rlim_t> file_bytes;     // no file grows larger: a full disk
  std::optional<rlim_t> address_bytes;  // of all its memory
  const char* output = nullptr;         // where standard output goes instead
};

struct Ended {
  int code = -1;     // if it ended by itself
  int signal = 0;    // that ended it; 0: none
  std::string said;  // on standard output and standard error
};

class Child {
 public:
  // state: its XDG_STATE_HOME, so that no session and no calibration of the tester's is read.
  Child(const std::vector<std::string>& arguments, const std::filesystem::path& state, const Room& room = {}) {
    int ends[2] = {};
    EXPECT_EQ(::pipe2(ends, O_CLOEXEC), 0);
    process_ = ::fork();
    if (process_ == 0) become(arguments, state, room, ends[1]);
    ::close(ends[1]);
    said_ = ends[0];
  }
  ~Child() {
    if (process_ > 0) kill(), wait();
  }
  Child(const Child&) = delete;

  void kill() const { ::kill(process_, SIGKILL); }
  Ended wait() {
    Ended out;
    char block[4096];
    for (ssize_t got = 0; (got = ::read(said_, block, sizeof block)) > 0;)
      out.said.append(block, static_cast<size_t>(got));
    ::close(said_);
    int status = 0;
    EXPECT_EQ(::waitpid(process_, &status, 0), process_);
    process_ = -1;
    if (WIFEXITED(status)) out.code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) out.signal = WTERMSIG(status);
    return out;
  }

 private:
  [[noreturn]] static void become(const std::vector<std::string>& arguments, const std::filesystem::path& state,
                                  const Room& room, int said) {
    ::dup2(room.output ? ::open(room.output, O_WRONLY) : said, STDOUT_FILENO), ::dup2(said, STDERR_FILENO);
    ::setenv("XDG_STATE_HOME", state.c_str(), 1);
    std::signal(SIGXFSZ, SIG_IGN);  // the write is refused instead
    limit(RLIMIT_FSIZE, room.file_bytes), limit(RLIMIT_AS, room.address_bytes);
    std::string program = test::program();
    std::vector<char*> words = {program.data()};
    for (const std::string& a : arguments) words.push_back(const_cast<char*>(a.c_str()));
    words.push_back(nullptr);
    ::execv(program.c_str(), words.data());
    ::_exit(127);
  }
  template <class Resource>
  static void limit(Resource resource, const std::optional<rlim_t>& most) {
    if (const rlimit both{most.value_or(0), most.value_or(0)}; most && ::setrlimit(resource, &both) != 0) ::_exit(126);
  }

  pid_t process_ = -1;
  int said_ = -1;
};

// Looks every few milliseconds, for a minute.
template <class There>
bool becomes(There there) {
  for (int k = 0; k < 12'000 && !there(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return there();
}

// What the program says of an error: its last line, which must be the only one that it complains in.
inline std::string complaint(const std::string& said) {
  const size_t at = said.rfind("gbufferlab: ");
  if (at == std::string::npos) return "";
  const std::string line = said.substr(at);
  return line.find('\n') + 1 == line.size() ? line.substr(0, line.size() - 1) : "more than one line: " + line;
}

}  // namespace gbl::test
