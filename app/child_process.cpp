#include "app/child_process.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include "renderer/base/error.h"

namespace gbl {
namespace {

[[noreturn]] void cannot_start() {
  throw Error(ExitCode::unfinished, "a process of its own", std::strerror(errno), "end other programs and try again");
}

class Pipe {
 public:
  Pipe() {
    if (::pipe(ends_) != 0) cannot_start();
  }
  ~Pipe() { close_end(0), close_end(1); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  int end(int which) const { return ends_[which]; }
  void close_end(int which) {
    if (ends_[which] >= 0) ::close(ends_[which]);
    ends_[which] = -1;
  }

 private:
  int ends_[2] = {-1, -1};
};

[[noreturn]] void become_child(const std::vector<std::string>& arguments, const Pipe& out, const Pipe& err) {
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody is left to judge for
#endif
  ::dup2(out.end(1), STDOUT_FILENO);
  ::dup2(err.end(1), STDERR_FILENO);
  std::vector<char*> argv;
  static char name[] = "gbufferlab";
  argv.push_back(name);
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  ::execv("/proc/self/exe", argv.data());
  ::_exit(static_cast<int>(ExitCode::unfinished));
}

// What has arrived; false at its end.
bool take(const Pipe& pipe, std::string& into) {
  char block[4096];
  const ssize_t got = ::read(pipe.end(0), block, sizeof block);
  if (got > 0) into.append(block, static_cast<size_t>(got));
  return got > 0 || (got < 0 && errno == EINTR);
}

}  // namespace

ChildResult run_child(const std::vector<std::string>& arguments, double limit_s) {
  Pipe out, err;
  const pid_t child = ::fork();
  if (child < 0) cannot_start();
  if (child == 0) become_child(arguments, out, err);
  out.close_end(1), err.close_end(1);

  using Clock = std::chrono::steady_clock;
  const Clock::time_point end =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limit_s));
  ChildResult result;
  bool open[2] = {true, true};
  while (open[0] || open[1]) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    pollfd ends[2] = {{open[0] ? out.end(0) : -1, POLLIN, 0}, {open[1] ? err.end(0) : -1, POLLIN, 0}};
    if (left <= 0) {
      result.timed_out = true;
      ::kill(child, SIGKILL);
      break;
    }
    if (::poll(ends, 2, static_cast<int>(std::min<long long>(left, 1000))) <= 0) continue;
    if (ends[0].revents != 0) open[0] = take(out, result.out);
    if (ends[1].revents != 0) open[1] = take(err, result.err);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  return result;
}

}  // namespace gbl
