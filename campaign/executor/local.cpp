// SPDX-License-Identifier: BSD-3-Clause
// Fork, become a session of its own, say who one is, exec.
#include "executor/local.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "executor/attempt.hpp"
#include "study/error.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

/// In the child: sends a message up the pipe, which closes by itself when exec succeeds.
[[noreturn]] void give_up(int pipe, const std::string& message) {
  const ssize_t ignored = ::write(pipe, message.data(), message.size());
  static_cast<void>(ignored);
  ::_exit(127);
}

void open_as(int target, const std::filesystem::path& file, int flags, int pipe) {
  const int fd = ::open(file.c_str(), flags | O_CLOEXEC, 0666);
  if (fd < 0 || ::dup2(fd, target) < 0) give_up(pipe, file.string() + ": cannot open: " + std::strerror(errno));
}

/// Where the kernel groups processes by session (autogroup), niceness weighs inside a session only, and a job has one
/// of its own: the session gets the niceness that the job was given or inherited.
void make_session_as_nice() {
  const int niceness = ::getpriority(PRIO_PROCESS, 0);
  const int fd = niceness > 0 ? ::open("/proc/self/autogroup", O_WRONLY | O_CLOEXEC) : -1;
  if (fd < 0) return;  // not nice, or no groups: nothing to do
  const std::string text = std::to_string(niceness);
  const ssize_t ignored = ::write(fd, text.data(), text.size());
  static_cast<void>(ignored);
  ::close(fd);
}

/// All that happens between fork and exec. The open database is not touched, and closes with exec.
[[noreturn]] void become_job(const Order& order, const std::vector<std::string>& command, int pipe) {
  ::setsid();
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGCHLD, SIGUSR2}) ::signal(signal, SIG_DFL);

  const std::filesystem::path attempt = attempt_directory(order.run_directory, order.attempt);
  open_as(STDIN_FILENO, "/dev/null", O_RDONLY, pipe);
  open_as(STDOUT_FILENO, attempt / "stdout", O_WRONLY | O_CREAT | O_APPEND, pipe);
  open_as(STDERR_FILENO, attempt / "stderr", O_WRONLY | O_CREAT | O_APPEND, pipe);
  if (::chdir(order.run_directory.c_str()) != 0)
    give_up(pipe, std::string("cannot enter the directory: ") + std::strerror(errno));
  if (!order.cores.empty() && !pin_to(order.cores)) {
    give_up(pipe, "cannot be pinned to cores " + to_text(order.cores) + ": " + std::strerror(errno));
  }
  if (order.niceness > 0 && ::setpriority(PRIO_PROCESS, 0, order.niceness) != 0) {
    give_up(pipe, std::string("cannot set the niceness: ") + std::strerror(errno));
  }
  make_session_as_nice();
  // Written by the job itself, before exec: a manager that dies right after fork leaves nothing that cannot be found.
  const std::optional<ProcessIdentity> self = identity_of(::getpid());
  if (!self) give_up(pipe, "/proc is not readable");
  try {
    write_whole_file(attempt / "process.json", process_json(*self, order.ranks, order.checkpoint_step));
  } catch (const Error& error) {
    give_up(pipe, error.what());
  }
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  ::execvp(arguments[0], arguments.data());
  give_up(pipe, command.front() + ": cannot be started: " + std::strerror(errno));
}

std::string read_to_end(int fd) {
  std::string text;
  std::array<char, 512> buffer;
  for (;;) {
    const ssize_t got = ::read(fd, buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(got));
  }
}

}  // namespace

std::vector<std::string> mpi_prefix(int ranks, int cores) {
  if (ranks == 1) return {};
  // The cores are set by us, for mpirun and all it starts; ranks move freely among them.
  std::vector<std::string> prefix = {
      "mpirun", "-n", std::to_string(ranks), "--host", "localhost:" + std::to_string(ranks), "--bind-to", "none"};
  // With fewer cores than ranks, spinning ranks would starve each other, so they yield.
  if (cores < ranks) prefix.insert(prefix.end(), {"--mca", "mpi_yield_when_idle", "1"});
  return prefix;
}

std::vector<std::string> job_command(const Order& order) {
  std::vector<std::string> command = mpi_prefix(order.ranks, static_cast<int>(order.cores.size()));
  command.insert(command.end(), {order.solver.string(), "run.ini", "--attempt", std::to_string(order.attempt),
                                 "--token", order.token});
  return command;
}

ProcessIdentity LocalExecutor::launch(const Order& order) {
  const std::vector<std::string> command = job_command(order);
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) fail(Exit::failed, "cannot make a pipe: {}.", std::strerror(errno));
  const pid_t pid = ::fork();
  if (pid == 0) become_job(order, command, pipe[1]);
  const int fork_error = errno;
  ::close(pipe[1]);
  const std::string trouble = pid < 0 ? std::string("cannot fork: ") + std::strerror(fork_error) : read_to_end(pipe[0]);
  ::close(pipe[0]);
  if (!trouble.empty()) {
    if (pid > 0) ::waitpid(pid, nullptr, 0);
    fail(Exit::failed, "{}: attempt {} did not start: {}", order.run_directory.string(), order.attempt, trouble);
  }
  // A job that ended already is not reaped yet, but then its identity is only in its process.json.
  return identity_of(pid).value_or(ProcessIdentity{host_name(), boot_id(), pid, 0});
}

void LocalExecutor::ask_to_stop(const ProcessIdentity& process, const std::filesystem::path& run_directory,
                                int attempt) {
  // Before started.json the solver may not catch signals yet and would be killed by one; the stop file reaches it then.
  std::error_code unseen;
  if (!std::filesystem::exists(attempt_directory(run_directory, attempt) / "started.json", unseen)) return;
  if (life_of(process) == Life::alive) ::kill(static_cast<pid_t>(process.pid), SIGUSR2);
}

void LocalExecutor::reap() {
  while (::waitpid(-1, nullptr, WNOHANG) > 0) {
  }
}

}  // namespace rouleau::campaign
