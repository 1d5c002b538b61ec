// SPDX-License-Identifier: BSD-3-Clause
// Job scripts as bash really runs them, with squeue, srun and solver played by scripts.
#pragma once

#include <gtest/gtest.h>
#include <signal.h>

#include "executor/attempt.hpp"
#include "executor/job_script.hpp"
#include "support/campaign_program.hpp"

namespace rouleau::campaign {

inline const std::string given_token = "0123456789abcdef0123456789abcdef";

/// Writes its arguments into its attempt; then as the file `behaviour` in the run directory says: `exit N`, or `wait`
/// until it gets SIGUSR2 (which kills it before it has written started.json, as it would the solver).
inline constexpr const char* fake_solver = R"(#!/bin/bash
attempt=attempts/$3
printf '%s\n' "$@" >$attempt/arguments
read -r what code <behaviour
[ "$what" = exit ] && exit "$code"
sleep "${code:-0}"
trap 'echo stopped >>$attempt/stopped; exit 75' USR2
echo {} >$attempt/started.json
while :; do sleep 0.02; done
)";

/// Drops its options; says what they were.
inline constexpr const char* fake_srun = R"(#!/bin/bash
options=
while [[ $1 == -* ]]; do
  options+=" $1"
  [ "$1" = -n ] && { options+=" $2"; shift; }
  shift
done
echo "srun$options"
exec "$@"
)";

class JobScriptRun : public ::testing::Test {
 protected:
  JobScriptRun()
      : bin_(place_.path() / "bin"),
        campaign_(place_.path() / "it's a $(touch hacked) \"sweep\""),
        before_(::getenv("PATH")) {
    std::filesystem::create_directories(bin_);
    std::filesystem::create_directories(campaign_);
    install("srun", fake_srun);
    install("the solver", fake_solver);
    install("squeue", "#!/bin/bash\necho 1:00:00\n");
    ::setenv("PATH", (bin_.string() + ":" + before_).c_str(), 1);
    ::setenv("SLURM_JOB_ID", "4711", 1);
    ::unsetenv("SLURM_RESTART_COUNT");
    cluster_.time_limit_s = 7200;
    job_ = {.solver = bin_ / "the solver",
            .campaign = campaign_,
            .name = "rouleau-" + given_token,
            .ranks = 1,
            .points = {},
            .at_end = {}};
  }
  ~JobScriptRun() override {
    ::setenv("PATH", before_.c_str(), 1);
    ::unsetenv("SLURM_JOB_ID");
    ::unsetenv("SLURM_RESTART_COUNT");
  }

  void install(const std::string& name, const std::string& text) {
    rouleau::testing::set_content(bin_ / name, text);
    std::filesystem::permissions(bin_ / name, std::filesystem::perms::owner_all);
  }

  /// A point of the job with attempt 1 claimed, as the manager leaves it.
  void add_point(const std::string& key, const std::string& behaviour) {
    const std::filesystem::path run = campaign_ / "points" / key;
    claim_attempt(run, 1, given_token);
    rouleau::testing::set_content(run / "behaviour", behaviour + "\n");
    job_.points.push_back({key, 1, given_token});
  }

  [[nodiscard]] std::filesystem::path attempt(const std::string& key, int number) const {
    return attempt_directory(campaign_ / "points" / key, number);
  }

  /// Starts the script as Slurm would, with its words in job.log of the first attempt.
  pid_t start() {
    rouleau::testing::set_content(script(), job_script(cluster_, job_));
    const pid_t pid = ::fork();
    if (pid == 0) {
      const std::string run = "exec bash " + shell_quoted(script().string()) + " >>" +
                              shell_quoted((attempt(job_.points.front().key, 1) / "job.log").string()) + " 2>&1";
      ::execlp("sh", "sh", "-c", run.c_str(), nullptr);
      ::_exit(127);
    }
    return pid;
  }
  static int end_of(pid_t pid) {
    int status = 0;
    ::waitpid(pid, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  int run() { return end_of(start()); }
  [[nodiscard]] std::string log() const {
    return rouleau::testing::content_of(attempt(job_.points.front().key, 1) / "job.log");
  }
  [[nodiscard]] std::filesystem::path script() const { return place_.path() / "job.sh"; }

  rouleau::testing::TemporaryDirectory place_;
  std::filesystem::path bin_, campaign_;
  Cluster cluster_;
  JobScript job_;

 private:
  std::string before_;
};

}  // namespace rouleau::campaign
