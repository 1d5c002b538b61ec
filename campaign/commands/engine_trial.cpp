// SPDX-License-Identifier: BSD-3-Clause
// The trial is a job like any other: the script of a point, in a folder that looks like a campaign.
#include "commands/engine_trial.hpp"

#include <signal.h>

#include <chrono>
#include <thread>

#include "executor/attempt.hpp"
#include "executor/job_script.hpp"
#include "executor/signals.hpp"
#include "ingest/run_files.hpp"
#include "jobs/slurm_state.hpp"
#include "study/error.hpp"
#include "study/numbers.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* key = "trial";
constexpr double trial_limit_s = 120;
constexpr int look_every_ms = 100;
constexpr double ask_every_s = 2;   // one job, one user: no burden for a controller
constexpr double say_every_s = 15;  // when nothing changes
constexpr double linger_s = 15;     // for files of an ended job to be seen through a network file system

/// Twenty steps of a small channel without a cell.
constexpr const char* run_file =
    "[channel]\nlength_x_um = 8\nlength_y_um = 8\nlength_z_um = 8\n"
    "[flow]\nmean_velocity_mm_per_s = 0.1\n[cell]\nshape = none\n"
    "[numerics]\nnode_spacing_um = 1\ntime_step_us = 1\n[time]\nend_time_s = 0.00002\n";

/// Lines for the script, before the solver: say where we are, wait for the answer from here, then say what time it is.
/// The clock is read between two moments that are known here, so no delay of the file system is taken for a wrong one.
const std::vector<std::string> greeting = {
    "hostname >node.tmp && mv -f node.tmp node",
    "for _ in $(seq 200); do ls >/dev/null; [ -e answer ] && break; sleep 0.2; done",
    "[ -e answer ] && date +%s.%N >clock.tmp && mv -f clock.tmp clock",
};

double unix_s() { return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count(); }

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// How far a clock that was read between two of our moments is from ours, at least.
double clock_ahead(double read, double before, double after) {
  if (read > after) return read - after;
  if (read < before) return read - before;
  return 0;
}

/// A folder with all in it, gone at the end of the scope.
class Folder {
 public:
  explicit Folder(std::filesystem::path path) : path_(std::move(path)) { make_directories(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    // A job that is being cancelled may still write for a moment.
    for (int tries = 0; tries < 10; ++tries) {
      std::error_code error;
      std::filesystem::remove_all(path_, error);
      if (!error) return;
      std::this_thread::sleep_for(std::chrono::seconds(1));
    }
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Follows one job from its release to its end.
class Watch {
 public:
  Watch(const Slurm& slurm, std::string id, const std::filesystem::path& folder, double wait_s,
        const std::function<void(const std::string&)>& say)
      : slurm_(slurm),
        id_(std::move(id)),
        folder_(folder),
        attempt_(attempt_directory(folder / "points" / key, 1)),
        wait_s_(wait_s),
        say_(say) {}

  void follow(Trial& trial) {
    SignalWatch signals;
    while (!is_over(trial)) {
      const int signal = signals.wait(look_every_ms);
      if (signal != 0 && signal != SIGCHLD) {
        trial.interrupted = true;
        trial.trouble = "interrupted; the job was cancelled";
        break;
      }
      look_at_files(trial);
      if (seconds_since(asked_) > ask_every_s) ask(trial);
    }
    if (!trial.trouble.empty()) return cancel(trial);
    look_at_files(trial);
  }

 private:
  bool is_over(Trial& trial) {
    if (std::filesystem::exists(attempt_ / "status")) return true;
    if (ended_ && seconds_since(*ended_) > linger_s) {
      trial.trouble = trial.node.empty() ? fmt::format(
                                               "the job has ended ({}), and nothing that it wrote is seen in {}. "
                                               "Name a directory that the nodes share",
                                               words_, folder_.parent_path().string())
                                         : fmt::format("the job ended early: {}", words_);
      return true;
    }
    if (seconds_since(start_) > wait_s_) {
      trial.trouble = fmt::format(
          "job {} was not at its end after {} s: {}. Wait longer with --wait-s, or see why with "
          "`squeue -j {}`; it was cancelled",
          id_, shortest(wait_s_), words_, id_);
      return true;
    }
    return false;
  }

  void look_at_files(Trial& trial) {
    if (trial.node.empty()) {
      trial.node = read_first_line(folder_ / "node").value_or("");
      if (trial.node.empty()) return;
      trial.seen_after_s = seconds_since(start_);
      answered_unix_s_ = unix_s();
      write_whole_file(folder_ / "answer", "seen\n");
      say_(fmt::format("job {} runs on {}", id_, trial.node));
    }
    if (!trial.clock_ahead_s) {
      const std::optional<double> clock = parse_number(read_first_line(folder_ / "clock").value_or(""));
      if (clock) trial.clock_ahead_s = clock_ahead(*clock, answered_unix_s_, unix_s());
    }
  }

  void ask(Trial& trial) {
    const JobList jobs = slurm_.jobs();
    asked_ = Clock::now();
    std::string now = words_;
    if (!jobs.answered) now = jobs.trouble;
    for (const JobRow& row : jobs.rows) {
      if (row.id != id_) continue;
      const JobView view = view_of(row.state, row.reason, row.nodes);
      now = view.words;
      if (view.phase == Phase::ended && !ended_) ended_ = Clock::now();
      if (view.phase == Phase::impossible) trial.trouble = fmt::format("job {} {}; it was cancelled", id_, view.words);
    }
    if (now != words_ || seconds_since(said_) > say_every_s) {
      say_(fmt::format("job {}: {}, {:.0f} s of {}", id_, now, seconds_since(start_), shortest(wait_s_)));
      said_ = Clock::now();
    }
    words_ = now;
    if (!trial.trouble.empty()) wait_s_ = 0;
  }

  void cancel(Trial& trial) {
    if (const std::string trouble = slurm_.cancel(id_); !trouble.empty()) {
      trial.trouble += fmt::format(" (but `scancel {}` failed: {})", id_, trouble);
    }
  }

  const Slurm& slurm_;
  std::string id_;
  std::filesystem::path folder_, attempt_;
  double wait_s_;
  const std::function<void(const std::string&)>& say_;
  Clock::time_point start_ = Clock::now(), asked_ = start_, said_ = start_;
  std::optional<Clock::time_point> ended_;
  double answered_unix_s_ = 0;
  std::string words_ = "submitted";
};

void read_outcome(const std::filesystem::path& folder, Trial& trial) {
  const std::filesystem::path attempt = attempt_directory(folder / "points" / key, 1);
  std::vector<std::string> warnings;
  if (const std::optional<ExitFile> exit = read_exit_file(attempt / "exit.json", warnings)) {
    trial.code = exit->code;
    trial.ranks = exit->ranks.value_or(0);
  }
  trial.last_words = last_line(attempt / "stderr");
  if (trial.last_words.empty()) trial.last_words = last_line(attempt / "job.log");
}

}  // namespace

std::string trial_script(const Cluster& cluster, const std::filesystem::path& solver,
                         const std::filesystem::path& folder, const std::string& token) {
  Cluster small = cluster;
  small.time_limit_s = trial_limit_s;
  small.points_per_job = 1;
  small.nodes = 1;
  small.signal_s = 0;
  small.requeue = 0;
  small.setup.push_back("cd " + shell_quoted(folder.native()));
  small.setup.insert(small.setup.end(), greeting.begin(), greeting.end());
  return job_script(small, {.solver = solver,
                            .campaign = folder,
                            .name = "rouleau-check-" + token,
                            .ranks = 2,
                            .points = {{key, 1, token}},
                            .at_end = {}});
}

Trial try_cluster(const Cluster& cluster, const TrialOrder& order, const std::function<void(const std::string&)>& say) {
  const std::string token = new_token();
  const Folder folder(order.directory / (".rouleau-check-" + token));
  const std::filesystem::path point = folder.path() / "points" / key;
  claim_attempt(point, 1, token);
  write_whole_file(point / "run.ini", run_file);
  const std::filesystem::path script = attempt_directory(point, 1) / "job.sh";
  write_whole_file(script, trial_script(cluster, order.solver, folder.path(), token));

  Trial trial;
  const Slurm slurm(cluster.client_timeout_s);
  const Submission submission = slurm.submit_held(script);
  if (submission.id.empty()) {
    trial.answers = !submission.transient;
    trial.trouble = submission.trouble;
    return trial;
  }
  trial.submitted = true;
  if (const std::string trouble = slurm.release(submission.id); !trouble.empty()) {
    trial.trouble = fmt::format("job {} could not be released: {}", submission.id, trouble);
    if (!slurm.cancel(submission.id).empty()) trial.trouble += fmt::format("; end it with `scancel {}`", submission.id);
    return trial;
  }
  say(fmt::format("job {} was submitted; waiting for it, {} s at most", submission.id, shortest(order.wait_s)));
  Watch(slurm, submission.id, folder.path(), order.wait_s, say).follow(trial);
  read_outcome(folder.path(), trial);
  return trial;
}

}  // namespace rouleau::campaign
