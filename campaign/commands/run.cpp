// SPDX-License-Identifier: BSD-3-Clause
// `rouleau run`: passes over the campaign until nothing is left to do.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <ostream>
#include <set>

#include "commands/engine_choice.hpp"
#include "commands/outcome.hpp"
#include "commands/progress_line.hpp"
#include "commands/verbs.hpp"
#include "executor/signals.hpp"

namespace rouleau::campaign {

namespace {

constexpr int tick_ms = 250;  // how soon signals and requests are heeded
constexpr auto ingest_interval = std::chrono::seconds(30);
constexpr double trouble_interval_s = 2;  // at least so long after a pass that trouble has ended

/// What the signals have asked for so far.
enum class Mood { running, stopping, leaving };

class Run {
 public:
  explicit Run(const CommandLine& line)
      : line_(line),
        progress_(line.io, line.quiet),
        manager_(line.directory, "run", [this](const std::string& message) { progress_.say(message); }) {}

  int operator()() {
    choose_engine(line_, manager_);
    manager_.take_requests();
    manager_.reconcile(true);
    if (line_.is_set("dry-run")) return print_scripts(line_, manager_);
    report_survivors();
    manager_.check_room();
    std::optional<int> code = survive([&] { return start(); });
    while (!code) code = survive([&] { return wait_and_pass(); });
    progress_.clear();
    return *code;
  }

 private:
  /// The exit code, when there is nothing more to do.
  std::optional<int> start() {
    if (mood_ == Mood::running) manager_.start();
    const bool has_more = mood_ == Mood::running    ? manager_.has_work()
                          : mood_ == Mood::stopping ? manager_.has_local_jobs()
                                                    : false;
    if (!has_more) return end();
    if (manager_.engine().self_sustaining && !manager_.has_local_jobs()) return hand_over();
    return std::nullopt;
  }

  std::optional<int> wait_and_pass() {
    wait_for_next_pass();
    manager_.take_requests();
    manager_.reconcile(is_disturbed_);  // nothing is concluded from half a pass
    is_disturbed_ = false;
    ingest_now_and_then();
    return start();
  }

  /// What waiting mends ends one pass, not the manager: jobs go on, and the next pass begins anew.
  template <class Act>
  std::optional<int> survive(const Act& act) {
    try {
      return act();
    } catch (const DatabaseError& error) {
      if (!error.waiting_mends()) throw;
      warn_of_trouble(error.what());
    } catch (const std::filesystem::filesystem_error& error) {
      warn_of_trouble(fmt::format("{}: {}; see that the disk is sound, has room and is yours to write",
                                  error.path1().string(), error.code().message()));
    }
    is_disturbed_ = true;
    if (mood_ == Mood::leaving) return static_cast<int>(Exit::interrupted);
    return std::nullopt;
  }

  void warn_of_trouble(const std::string& what) {
    if (!troubles_.insert(what).second) return;
    progress_.say("warning: " + what + ". Jobs go on, and this rouleau tries again every few seconds.");
  }

  /// The campaign goes on by the passes that its jobs make.
  int hand_over() {
    progress_.say(counts_text(manager_.counts()) +
                  ". The jobs keep the campaign going; `rouleau status` shows how far.");
    return static_cast<int>(outcome_of(manager_));
  }

  void wait_for_next_pass() {
    const double seconds = std::max(manager_.pass_interval_s(), is_disturbed_ ? trouble_interval_s : 0);
    const auto next = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    do {
      if (!is_disturbed_) progress_.show(manager_);
      const int signal = signals_.wait(tick_ms);
      heed(signal);
      if (signal != 0) return;
      if (is_disturbed_) continue;  // a request that could not be carried out is there still
      std::vector<std::string> told_by_the_pass;
      if (!requests_in(manager_.directory(), told_by_the_pass).empty()) return;
    } while (std::chrono::steady_clock::now() < next);
  }

  void report_survivors() {
    for (const LivingJob& job : manager_.living()) {
      if (job.is_seen)
        progress_.say(fmt::format("#{}: attempt {} is still running; taken over", job.ordinal, job.attempt));
    }
  }

  void heed(int signal) {
    if (signal == SIGHUP) {
      mood_ = Mood::leaving;
    } else if (signal == SIGINT || signal == SIGTERM) {
      if (mood_ == Mood::stopping) {
        mood_ = Mood::leaving;
        return;
      }
      mood_ = Mood::stopping;
      progress_.say(manager_.has_local_jobs()
                        ? fmt::format("stopping: {} jobs are asked to write a checkpoint and end. Ctrl-C again "
                                      "leaves without waiting for them.",
                                      manager_.living().size())
                    : manager_.living().empty() ? "stopping: no job runs"
                                                : "stopping: jobs of Slurm go on");
      manager_.ask_to_stop();
    }
  }

  void ingest_now_and_then() {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ingest_ < ingest_interval) return;
    last_ingest_ = now;
    manager_.ingest_living();
  }

  int end() {
    if (mood_ != Mood::running) {
      if (!manager_.living().empty()) {
        progress_.say(
            fmt::format("left {} jobs to themselves; `rouleau run` takes them over again", manager_.living().size()));
      }
      progress_.say(counts_text(manager_.counts()) + ". `rouleau run` continues.");
      return static_cast<int>(Exit::interrupted);
    }
    progress_.say(counts_text(manager_.counts()));
    return static_cast<int>(outcome_of(manager_));
  }

  const CommandLine& line_;
  ProgressLine progress_;
  SignalWatch signals_;  // before the manager: no signal is lost while it opens the campaign
  Manager manager_;
  Mood mood_ = Mood::running;
  bool is_disturbed_ = false;       ///< trouble has ended the pass before
  std::set<std::string> troubles_;  ///< each is said once
  std::chrono::steady_clock::time_point last_ingest_ = std::chrono::steady_clock::now();
};

int run(const CommandLine& line) { return Run(line)(); }

}  // namespace

const Verb run_verb = {
    "run",
    "run all points to their end; again after any interruption",
    "[DIR] [--engine local|slurm] [--cluster FILE] [--self-sustaining] [--dry-run]",
    "  rouleau run my-campaign        start, continue, retry: whatever is to be done\n"
    "  rouleau run                    the same in the current directory\n"
    "  rouleau run my-campaign --engine slurm --cluster my-cluster.ini   on a cluster, from a login node\n",
    "Jobs outlive rouleau: after a crash of rouleau or of jobs, `rouleau run` again is the whole recovery.\n"
    "Ctrl-C (or SIGTERM) once: running jobs write a checkpoint and stop; nothing is lost. Twice: do not wait\n"
    "for them. SIGHUP: leave at once, jobs go on. The number of jobs at a time, ranks and retries are set in\n"
    "the study file, section [execution].\n"
    "Ends with 0 when all points are done (or cancelled), with 4 when some failed.\n",
    Words::campaign,
    false,
    describe_engine,
    run,
};

}  // namespace rouleau::campaign
