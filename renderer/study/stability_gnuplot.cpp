#include "renderer/study/stability_gnuplot.h"

#include <cstdio>
#include <fmt/format.h>
#include <memory>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "renderer/error.h"

extern char** environ;

namespace gbl {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// A file without a name: a pipe would block when gnuplot stops reading.
File scratch_file() {
  File file(std::tmpfile(), std::fclose);
  if (!file) throw Error(ExitCode::unfinished, "gnuplot", "no temporary file can be made", "make room for one");
  return file;
}

// The exit status, as waitpid() tells it.
int run(std::FILE* in, std::FILE* out) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, fileno(in), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, fileno(out), STDOUT_FILENO);
  std::string name = "gnuplot", no_user_file = "-d", from_stdin = "-";
  char* arguments[] = {name.data(), no_user_file.data(), from_stdin.data(), nullptr};
  pid_t child = 0;
  const int error = posix_spawnp(&child, name.c_str(), &files, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0)
    throw Error(ExitCode::unfinished, "gnuplot", "cannot be started, so no chart was drawn",
                "install the package gnuplot-nox and run this again");
  int status = -1;
  waitpid(child, &status, 0);
  return status;
}

}  // namespace

std::string drawn_by_gnuplot(const std::string& script) {
  const File in = scratch_file(), out = scratch_file();
  std::fwrite(script.data(), 1, script.size(), in.get());
  std::fflush(in.get());
  std::rewind(in.get());
  if (run(in.get(), out.get()) != 0)
    throw Error(ExitCode::unfinished, "gnuplot", "did not draw the chart",
                "it needs the terminals svg and pngcairo: install the package gnuplot-nox");
  std::string picture;
  std::rewind(out.get());
  char block[65536];
  for (size_t n = 0; (n = std::fread(block, 1, sizeof block, out.get())) > 0;) picture.append(block, n);
  return picture;
}

}  // namespace gbl
