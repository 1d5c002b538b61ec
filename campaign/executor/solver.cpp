// SPDX-License-Identifier: BSD-3-Clause
// Running short commands and reading what they say.
#include "executor/solver.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "study/error.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

bool is_program(const std::filesystem::path& file) {
  return std::filesystem::is_regular_file(file) && ::access(file.c_str(), X_OK) == 0;
}

/// A pipe whose ends close themselves.
struct Pipe {
  Pipe() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail(Exit::failed, "cannot make a pipe: {}.", std::strerror(errno));
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    for (const int end : ends) {
      if (end >= 0) ::close(end);
    }
  }
  void close_writer() {
    ::close(ends[1]);
    ends[1] = -1;
  }
  std::array<int, 2> ends{};
};

/// Reads both streams until both are closed.
void drain(Pipe& out, Pipe& err, Capture& capture) {
  std::array<pollfd, 2> waits = {{{out.ends[0], POLLIN, 0}, {err.ends[0], POLLIN, 0}}};
  const std::array<std::string*, 2> texts = {&capture.out, &capture.err};
  char buffer[4096];
  while (waits[0].fd >= 0 || waits[1].fd >= 0) {
    if (::poll(waits.data(), waits.size(), -1) < 0 && errno != EINTR) return;
    for (std::size_t i = 0; i < waits.size(); ++i) {
      if (waits[i].fd < 0 || waits[i].revents == 0) continue;
      const ssize_t got = ::read(waits[i].fd, buffer, sizeof buffer);
      if (got > 0) {
        texts[i]->append(buffer, static_cast<std::size_t>(got));
      } else if (got == 0 || errno != EINTR) {
        waits[i].fd = -1;
      }
    }
  }
}

int wait_for(pid_t pid) {
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

std::filesystem::path find_solver() {
  const char* name = "rouleau-solver";
  if (const char* given = std::getenv("ROULEAU_SOLVER"); given != nullptr && *given != '\0') {
    if (!is_program(given)) fail(Exit::failed, "ROULEAU_SOLVER = {} is not a program. Correct or unset it.", given);
    return std::filesystem::absolute(given);
  }
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error && is_program(self.parent_path() / name)) return self.parent_path() / name;
  const char* path = std::getenv("PATH");
  std::string rest = path == nullptr ? "" : path;
  while (!rest.empty()) {
    const std::size_t colon = rest.find(':');
    const std::filesystem::path place = std::filesystem::path(rest.substr(0, colon)) / name;
    if (is_program(place)) return std::filesystem::absolute(place);
    rest = colon == std::string::npos ? "" : rest.substr(colon + 1);
  }
  fail(Exit::failed, "rouleau-solver is neither beside {} nor on the PATH. Build it, or set ROULEAU_SOLVER.",
       self.string());
}

Capture run_and_capture(const std::vector<std::string>& command, const std::filesystem::path& directory) {
  Pipe out, err;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  const std::unique_ptr<posix_spawn_file_actions_t, int (*)(posix_spawn_file_actions_t*)> release(
      &actions, posix_spawn_file_actions_destroy);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, out.ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err.ends[1], STDERR_FILENO);
  if (!directory.empty()) posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());

  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t pid = 0;
  const int error = ::posix_spawnp(&pid, arguments[0], &actions, nullptr, arguments.data(), environ);
  if (error != 0) fail(Exit::failed, "cannot start {}: {}.", command.front(), std::strerror(error));
  out.close_writer();
  err.close_writer();
  Capture capture;
  drain(out, err, capture);
  capture.status = wait_for(pid);
  return capture;
}

Checker solver_checker(const std::filesystem::path& solver) {
  const auto scratch = std::make_shared<ScratchDirectory>();
  return [solver, scratch](const std::string& run_file) {
    const std::filesystem::path file = scratch->path() / "run.ini";
    write_whole_file(file, run_file);
    const Capture capture = run_and_capture({solver.string(), "check", "run.ini", "--format", "json"}, scratch->path());
    CheckOutcome outcome;
    if (capture.status == 0) {
      outcome.reply = parse_check(capture.out);
    } else if (capture.status == 65 && !capture.err.empty()) {
      outcome.error = capture.err;
    } else {
      fail(Exit::failed, "{} check ended with status {}: {}. Try it by hand on a run file.", solver.string(),
           capture.status, capture.err.empty() ? "no message" : capture.err);
    }
    return outcome;
  };
}

ScratchDirectory::ScratchDirectory() {
  std::string name = (std::filesystem::temp_directory_path() / "rouleau-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    fail(Exit::failed, "{}: cannot make a scratch directory: {}. Set TMPDIR to a writable one.", name,
         std::strerror(errno));
  }
  path_ = name;
}

ScratchDirectory::~ScratchDirectory() {
  std::error_code ignored;  // rubbish in the temporary directory is no reason to end a program
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace rouleau::campaign
