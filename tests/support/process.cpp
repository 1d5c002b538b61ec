// SPDX-License-Identifier: BSD-3-Clause
#include "support/process.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

namespace rouleau::testing {

namespace {

/// An unnamed file that takes what a process prints; unlike a pipe it never fills up.
class Capture {
 public:
  Capture() : file_(std::tmpfile()) {
    if (!file_) std::abort();
  }
  ~Capture() { std::fclose(file_); }
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;
  [[nodiscard]] int descriptor() const { return fileno(file_); }
  std::string text() {
    std::string all;
    std::rewind(file_);
    for (int c = std::fgetc(file_); c != EOF; c = std::fgetc(file_)) all.push_back(static_cast<char>(c));
    return all;
  }

 private:
  std::FILE* file_;
};

}  // namespace

Finished run_program(const std::vector<std::string>& words, std::optional<Interruption> interruption) {
  Capture out, err;
  const pid_t child = fork();
  if (child == 0) {
    setpgid(0, 0);
    dup2(open("/dev/null", O_RDONLY), 0);
    dup2(out.descriptor(), 1);
    dup2(err.descriptor(), 2);
    std::vector<char*> arguments;
    for (const auto& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  setpgid(child, child);
  auto begun = std::chrono::steady_clock::now();
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (interruption && !interruption->file.empty()) {
      std::error_code missing;
      const std::uintmax_t bytes = std::filesystem::file_size(interruption->file, missing);
      if (missing || bytes < interruption->bytes) continue;
      interruption->file.clear();
      begun = std::chrono::steady_clock::now();
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begun;
    if (interruption && passed.count() >= interruption->after_s) {
      kill(interruption->signal == SIGKILL ? -child : child, interruption->signal);
      interruption.reset();
    }
  }
  Finished finished;
  if (WIFEXITED(status)) finished.code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) finished.signal = WTERMSIG(status);
  finished.out = out.text();
  finished.err = err.text();
  return finished;
}

std::vector<std::string> launcher(int ranks) {
  if (ranks == 1) return {};
  return {"mpirun", "--oversubscribe",    "--bind-to", "none", "--mca", "mpi_yield_when_idle", "1",
          "-n",     std::to_string(ranks)};
}

}  // namespace rouleau::testing
