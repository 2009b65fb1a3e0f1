#include "renderer/base/external_program.h"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "renderer/base/error.h"

namespace gbl {

bool run_program_if_there(const std::string& name, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), name);
  std::vector<char*> words;
  for (std::string& a : arguments) words.push_back(a.data());
  words.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, STDERR_FILENO, STDOUT_FILENO);  // standard output is for answers
  pid_t child = 0;
  const int error = posix_spawnp(&child, name.c_str(), &files, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (error == ENOENT) return false;
  if (error != 0) throw Error(ExitCode::unfinished, name, fmt::format("cannot be started: {}", std::strerror(error)));
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw Error(ExitCode::unfinished, name, std::strerror(errno));
  if (status != 0) throw Error(ExitCode::unfinished, name, "did not do its work; what it said stands above");
  return true;
}

}  // namespace gbl
