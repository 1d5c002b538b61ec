// SPDX-License-Identifier: BSD-3-Clause
// A campaign in a directory of its own, driven by the real `rouleau` program, with the fake solver unless told
// otherwise.
#pragma once

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "executor/solver.hpp"
#include "store/store.hpp"
#include "study/whole_file.hpp"
#include "support/temporary_directory.hpp"

// Set by the build: where the two programs lie.
#if !defined(ROULEAU_PROGRAM) || !defined(FAKE_SOLVER_PROGRAM)
#error "link campaign_program_support"
#endif

namespace rouleau::testing {

/// Waits until the condition holds.   returns false when it did not within a minute (a busy machine needs some)
inline bool eventually(const std::function<bool()>& condition) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

class CampaignProgram {
 public:
  using Capture = rouleau::campaign::Capture;
  using Store = rouleau::campaign::Store;

  explicit CampaignProgram(std::string solver = FAKE_SOLVER_PROGRAM) : solver_(std::move(solver)) {
    ::setenv("ROULEAU_SOLVER", solver_.c_str(), 1);
    set_speed(100, 50);
  }
  ~CampaignProgram() {
    for (const pid_t pid : jobs()) ::kill(pid, SIGKILL);
  }
  CampaignProgram(const CampaignProgram&) = delete;
  CampaignProgram& operator=(const CampaignProgram&) = delete;

  /// Speed of fake solvers started from now on.
  static void set_speed(int microseconds_a_step, int steps_a_checkpoint) {
    ::setenv("FAKE_STEP_US", std::to_string(microseconds_a_step).c_str(), 1);
    ::setenv("FAKE_CHECKPOINT_STEPS", std::to_string(steps_a_checkpoint).c_str(), 1);
  }

  [[nodiscard]] std::filesystem::path path() const { return place_.path(); }
  [[nodiscard]] std::filesystem::path campaign() const { return path() / "c"; }
  [[nodiscard]] std::filesystem::path study() const { return path() / "study.ini"; }

  /// A study of the fake solver with 0.01 s = 100 steps; `rest` adds sections. Retries do not wait.
  void write_study(const std::string& sweep, const std::string& rest = "",
                   const std::string& end_time_s = "0.01") const {
    set_content(
        study(),
        "[study]\nname = small\n[channel]\nlength_x_um = 20\n[numerics]\ntime_step_us = 100\n[time]\nend_time_s = " +
            end_time_s + "\n[sweep]\n" + sweep + "\n[analysis]\nwindow_s = 0.005\noscillation_window_s = 0.01\n" +
            rest);
  }
  /// [execution] that lets several jobs share this machine's cores and retries at once.
  static std::string execution(const std::string& more = "") {
    return "[execution]\njobs = 2\noversubscribe = 1\nretry_delay_s = 0\nio_retry_delay_s = 0\npause_after_failures = "
           "0\n" +
           more;
  }

  /// `rouleau WORDS` to its end.
  [[nodiscard]] Capture rouleau(const std::vector<std::string>& words) const {
    std::vector<std::string> command = {ROULEAU_PROGRAM};
    command.insert(command.end(), words.begin(), words.end());
    return rouleau::campaign::run_and_capture(command, path());
  }
  [[nodiscard]] Capture init() const { return rouleau({"init", "study.ini", "c"}); }
  [[nodiscard]] Capture run() const { return rouleau({"run", "c"}); }

  /// `rouleau WORDS` in the background, stderr to the file `err` beside the campaign.
  [[nodiscard]] pid_t start(const std::vector<std::string>& words) const {
    std::fflush(nullptr);  // or the child writes our buffers again
    const pid_t pid = ::fork();
    if (pid != 0) return pid;
    ::setsid();
    if (::chdir(path().c_str()) != 0 || std::freopen("err", "w", stderr) == nullptr ||
        std::freopen("/dev/null", "w", stdout) == nullptr) {
      ::_exit(99);
    }
    std::vector<char*> arguments = {const_cast<char*>(ROULEAU_PROGRAM)};
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    ::execv(ROULEAU_PROGRAM, arguments.data());
    ::_exit(98);
  }
  /// The exit code of a started one; 1000 + signal if a signal ended it.
  static int wait_for(pid_t pid) {
    int status = 0;
    ::waitpid(pid, &status, 0);
    return WIFSIGNALED(status) ? 1000 + WTERMSIG(status) : WEXITSTATUS(status);
  }
  [[nodiscard]] std::string messages() const { return content_of(path() / "err"); }

  /// Living solvers of this campaign (by their working directory).
  [[nodiscard]] std::vector<pid_t> jobs() const {
    return processes([&](const std::filesystem::path& program) { return program == solver_; });
  }
  /// Living mpiruns of this campaign.
  [[nodiscard]] std::vector<pid_t> launchers() const {
    return processes([](const std::filesystem::path& program) {
      return program.filename() == "orterun" || program.filename() == "mpirun" ||
             program.filename() == "mpirun.openmpi";
    });
  }

  [[nodiscard]] Store store() const { return Store::open_reader(campaign() / "campaign.db"); }
  /// The point with that ordinal.
  [[nodiscard]] rouleau::campaign::PointRow point(int ordinal) const {
    return store().points().at(static_cast<std::size_t>(ordinal - 1));
  }
  [[nodiscard]] rouleau::campaign::State state(int ordinal) const { return point(ordinal).state; }
  [[nodiscard]] std::filesystem::path run_directory(int ordinal) const {
    return campaign() / "points" / point(ordinal).key;
  }
  /// Scripts trouble for the next starts of a point: one line a start (tests/support/fake_solver/README.md).
  void script(int ordinal, const std::string& lines) const { set_content(run_directory(ordinal) / "fake", lines); }

 private:
  [[nodiscard]] std::vector<pid_t> processes(
      const std::function<bool(const std::filesystem::path& program)>& is_wanted) const {
    std::vector<pid_t> found;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      const pid_t pid = std::atoi(entry.path().filename().c_str());
      if (pid <= 0) continue;
      std::error_code error;
      const auto program = std::filesystem::read_symlink(entry.path() / "exe", error);
      if (error || !is_wanted(program)) continue;
      const auto directory = std::filesystem::read_symlink(entry.path() / "cwd", error);
      if (!error && directory.string().starts_with(campaign().string())) found.push_back(pid);
    }
    return found;
  }

  std::string solver_;
  TemporaryDirectory place_;
};

}  // namespace rouleau::testing
