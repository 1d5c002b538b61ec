// SPDX-License-Identifier: BSD-3-Clause
// posix_spawn with pipes for both streams, and a clock.
#include "executor/capture.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <string_view>

#include "study/error.hpp"

namespace rouleau::campaign {

namespace {

using Clock = std::chrono::steady_clock;
using Deadline = std::optional<Clock::time_point>;

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

/// What poll() may wait: -1 = for ever.
int left_ms(const Deadline& deadline) {
  if (!deadline) return -1;
  const double left = std::chrono::duration<double, std::milli>(*deadline - Clock::now()).count();
  return static_cast<int>(std::clamp(std::ceil(left), 0.0, 1e9));
}

/// Reads both streams until both are closed or the time has come.
void drain(const Pipe& out, const Pipe& err, const Deadline& deadline, Capture& capture) {
  std::array<pollfd, 2> waits = {{{out.ends[0], POLLIN, 0}, {err.ends[0], POLLIN, 0}}};
  const std::array<std::string*, 2> texts = {&capture.out, &capture.err};
  char buffer[4096];
  while (waits[0].fd >= 0 || waits[1].fd >= 0) {
    const int ready = ::poll(waits.data(), waits.size(), left_ms(deadline));
    if (ready < 0 && errno != EINTR) return;
    for (std::size_t i = 0; i < waits.size() && ready > 0; ++i) {
      if (waits[i].fd < 0 || waits[i].revents == 0) continue;
      const ssize_t got = ::read(waits[i].fd, buffer, sizeof buffer);
      if (got > 0) {
        texts[i]->append(buffer, static_cast<std::size_t>(got));
      } else if (got == 0 || errno != EINTR) {
        waits[i].fd = -1;
      }
    }
    if (deadline && Clock::now() >= *deadline) return;
  }
}

/// Whether the child has ended; its status then. It is not waited for.
bool has_ended(pid_t pid, int& status) {
  pid_t got = 0;
  do {
    got = ::waitpid(pid, &status, WNOHANG);
  } while (got < 0 && errno == EINTR);
  return got != 0;
}

/// Waits for the child's end; kills its group when the time has come.   returns waitpid's status
int end_of(pid_t pid, const Deadline& deadline, Capture& capture) {
  int status = 0;
  constexpr useconds_t look_every_us = 5000;  // both streams are closed by now, so the end is near
  while (deadline && Clock::now() < *deadline) {
    if (has_ended(pid, status)) return status;
    ::usleep(look_every_us);
  }
  if (deadline) {
    // A child that has ended but left others behind with its streams is not late. They are, and go with the group.
    const bool is_late = !has_ended(pid, status);
    ::kill(-pid, SIGKILL);
    if (!is_late) return status;
    capture.timed_out = true;
  }
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

/// Spawn attributes and file actions that release themselves.
struct Spawn {
  Spawn() {
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
  }
  Spawn(const Spawn&) = delete;
  Spawn& operator=(const Spawn&) = delete;
  ~Spawn() {
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
  }
  /// Out of our process group, with no signal blocked: whoever waits for signals has blocked some.
  void set_apart() {
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
  }
  posix_spawn_file_actions_t actions{};
  posix_spawnattr_t attributes{};
};

std::vector<char*> as_c_array(const std::vector<std::string>& words) {
  std::vector<char*> array;
  for (const std::string& word : words) array.push_back(const_cast<char*>(word.c_str()));
  array.push_back(nullptr);
  return array;
}

}  // namespace

Capture run_and_capture(const std::vector<std::string>& command, const CaptureSettings& settings) {
  Pipe out, err;
  Spawn spawn;
  posix_spawn_file_actions_addopen(&spawn.actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&spawn.actions, out.ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&spawn.actions, err.ends[1], STDERR_FILENO);
  if (!settings.directory.empty()) {
    posix_spawn_file_actions_addchdir_np(&spawn.actions, settings.directory.c_str());
  }
  Deadline deadline;
  if (settings.time_out_s > 0) {
    deadline =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(settings.time_out_s));
    spawn.set_apart();
  }
  const std::vector<char*> arguments = as_c_array(command);
  std::vector<char*> variables;
  if (settings.environment) variables = as_c_array(*settings.environment);
  pid_t pid = 0;
  const int error = ::posix_spawnp(&pid, arguments[0], &spawn.actions, &spawn.attributes, arguments.data(),
                                   settings.environment ? variables.data() : environ);
  if (error != 0) fail(Exit::failed, "cannot start {}: {}.", command.front(), std::strerror(error));
  out.close_writer();
  err.close_writer();
  Capture capture;
  drain(out, err, deadline, capture);
  const int status = end_of(pid, deadline, capture);
  capture.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return capture;
}

Capture run_and_capture(const std::vector<std::string>& command, const std::filesystem::path& directory) {
  return run_and_capture(command, CaptureSettings{.directory = directory, .time_out_s = 0, .environment = {}});
}

std::vector<std::string> environment_without_slurm() {
  constexpr std::array<std::string_view, 6> prefixes = {"SLURM_", "SBATCH_", "SQUEUE_", "SCANCEL_", "SRUN_", "SALLOC_"};
  constexpr std::array<std::string_view, 2> kept = {"SLURM_CONF=", "SLURM_JWT="};
  std::vector<std::string> variables;
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    const std::string_view variable = *entry;
    const auto begins_it = [&](std::string_view prefix) { return variable.starts_with(prefix); };
    if (std::any_of(prefixes.begin(), prefixes.end(), begins_it) && std::none_of(kept.begin(), kept.end(), begins_it)) {
      continue;
    }
    variables.emplace_back(variable);
  }
  return variables;
}

}  // namespace rouleau::campaign
