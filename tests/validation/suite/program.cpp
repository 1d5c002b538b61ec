// SPDX-License-Identifier: BSD-3-Clause
#include "program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>

#include "base/error.hpp"

namespace rouleau::validation {
namespace {

std::vector<std::string>& environment() {
  static std::vector<std::string> kept;
  return kept;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> each;
  for (std::string& text : texts) each.push_back(text.data());
  each.push_back(nullptr);
  return each;
}

int wait_for(pid_t pid) {
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

void keep_environment() {
  environment().clear();
  for (char** variable = environ; *variable != nullptr; ++variable) environment().emplace_back(*variable);
}

Ended run_program(const std::vector<std::string>& words) {
  if (environment().empty()) keep_environment();
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) fail(Exit::io, "cannot make a pipe: {}", std::strerror(errno));
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, pipe[1], STDOUT_FILENO);
  std::vector<std::string> arguments = words;
  pid_t pid = 0;
  const int error = ::posix_spawnp(&pid, words.front().c_str(), &actions, nullptr, pointers(arguments).data(),
                                   pointers(environment()).data());
  posix_spawn_file_actions_destroy(&actions);
  ::close(pipe[1]);
  Ended ended;
  char buffer[4096];
  for (ssize_t got = 1; error == 0 && got != 0;) {
    got = ::read(pipe[0], buffer, sizeof buffer);
    if (got > 0) ended.out.append(buffer, static_cast<std::size_t>(got));
    if (got < 0 && errno != EINTR) break;
  }
  ::close(pipe[0]);
  if (error != 0) fail(Exit::io, "cannot start {}: {}. Build it first", words.front(), std::strerror(error));
  ended.status = wait_for(pid);
  return ended;
}

}  // namespace rouleau::validation
