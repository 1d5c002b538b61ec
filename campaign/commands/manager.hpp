// SPDX-License-Identifier: BSD-3-Clause
// One pass over a campaign under its lock: what was recorded, what runs, what the directories prove, what to start.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "commands/evidence.hpp"
#include "commands/request.hpp"
#include "commands/slurm_engine.hpp"
#include "executor/job_script.hpp"
#include "executor/local.hpp"
#include "executor/lock.hpp"
#include "jobs/breaker.hpp"
#include "jobs/schedule.hpp"
#include "store/store.hpp"
#include "study/error.hpp"
#include "study/point.hpp"
#include "study/study.hpp"

namespace rouleau::campaign {

/// A job that lives, or may live out of our sight.
struct LivingJob {
  std::string key;
  int ordinal = 0;
  int attempt = 0;
  int ranks = 1;
  bool is_seen = true;  ///< false: it runs (or ran) on another host
  ProcessIdentity process;
  std::optional<JobFile> job;  ///< set: it runs under Slurm
  std::string words;           ///< what Slurm says of it
};

/// Where new jobs are started, and whether they keep the campaign going by themselves.
struct Engine {
  std::string name = std::string(local_engine);
  bool self_sustaining = false;  ///< Slurm: each job makes a pass over the campaign at its end
};

/// How many points of the study are in each state.
using StateCounts = std::map<State, int>;

/// Holds the lock and the database of one campaign. Every public function leaves the campaign such that a kill -9 at
/// any moment needs no manual step. A DatabaseError is such a moment too: what was begun is found by the next pass.
class Manager {
 public:
  using Say = std::function<void(const std::string&)>;

  /// Takes the lock and opens the database.   throws Error (not_found, locked, failed)
  Manager(const std::filesystem::path& directory, const std::string& verb, Say say, LockPatience patience = {});

  /// Sets the engine of this manager; keep_engine() of all later passes as well, in the file DIR/engine.
  /// throws Error (usage) if Slurm is asked for and there is no such cluster file
  void use_engine(const Engine& engine, const std::filesystem::path& cluster);
  void keep_engine();
  [[nodiscard]] const Engine& engine() const { return engine_; }

  /// Carries out the requests that `cancel` and `retry` left.
  void take_requests();

  /// Judges points and records what became of them. `all`: every point, as must be done once, and again after a pass
  /// that a DatabaseError has ended; otherwise only those with an attempt whose end is not recorded.
  void reconcile(bool all);

  /// Warns if the disk has less room than the points left will need until their ends.
  void check_room();

  /// Starts what can be started now.   returns how many
  int start();

  /// The job scripts that start() would submit now, without submitting anything or claiming an attempt.
  [[nodiscard]] std::vector<std::string> scripts();

  /// Asks every living job of this host to write a checkpoint and end. Jobs of Slurm go on.
  void ask_to_stop();

  /// Brings the samples of living points into the database.
  void ingest_living();

  [[nodiscard]] const std::vector<LivingJob>& living() const { return living_; }
  /// Whether something lives in our sight, or can be started now or later.
  [[nodiscard]] bool has_work() const;
  /// Seconds until the next paused point may start; 0 = none is paused.
  [[nodiscard]] double next_retry_in_s() const;
  [[nodiscard]] StateCounts counts() const;  ///< of points that the study names
  [[nodiscard]] bool is_paused() const { return breaker_.has_tripped(); }
  /// Whether jobs of this host live.
  [[nodiscard]] bool has_local_jobs() const;
  /// Why Slurm did not answer in this pass; "" = it did, or was not needed.
  [[nodiscard]] std::string engine_trouble() const { return slurm_ ? slurm_->trouble() : ""; }
  /// Seconds between passes that suit the engine.
  [[nodiscard]] double pass_interval_s() const;
  [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }

 private:
  void read_engine();
  void open_slurm(const std::filesystem::path& cluster);
  void look_at_queue();
  void cancel_orphans();
  [[nodiscard]] LifeOf life_of_attempt(const AttemptRow* row) const;
  [[nodiscard]] Gathered gather_of(const PointRow& point, const AttemptRow* newest) const;
  void look_at_points(bool all, const std::vector<LivingJob>& before);
  void keep_alive(const LivingJob& job);
  void settle(const PointRow& point);
  void leave_queue(const AttemptRow& attempt, const Gathered& gathered);
  void follow_job(const PointRow& point, AttemptRow* newest, const Gathered& gathered);
  void record(const PointRow& point, const AttemptRow* newest, const Gathered& gathered, const Verdict& verdict);
  void add_unknown_attempts(const PointRow& point, int recorded_attempt, const Gathered& gathered);
  void note_end(const PointRow& point, const Recorded& recorded, const Gathered& gathered, const Verdict& verdict);
  void finish(const std::string& key);
  void note_failure(const std::string& key, const std::string& reason);
  void note_progress();
  void warn_of(const std::vector<std::string>& warnings);
  void cancel(const PointRow& point);
  void retry(const PointRow& point);
  [[nodiscard]] std::int64_t room_of_living() const;
  [[nodiscard]] bool take_room_for(const PointRow& point);
  [[nodiscard]] AttemptRow planned_attempt(const PointRow& point, const Cores& cores) const;
  void fit_to_directory(AttemptRow& attempt) const;  ///< its number and what it starts from
  bool start_point(const PointRow& point, const Cores& cores);
  int start_here();
  int submit();
  [[nodiscard]] std::vector<std::vector<PointRow>> next_packs() const;
  [[nodiscard]] JobScript script_of(const std::vector<AttemptRow>& attempts);
  bool submit_pack(std::vector<PointRow> points);
  void claim_pack(const std::vector<PointRow>& points, const std::vector<AttemptRow>& attempts,
                  const JobScript& script);
  [[nodiscard]] AttemptRow planned_job_attempt(const PointRow& point) const;
  bool test_submission(const JobScript& script);
  void write_job_file(const AttemptRow& attempt, const JobFile& job) const;
  [[nodiscard]] static LaunchTrouble trouble_of(const Error& error);  ///< before the attempt was claimed
  void record_failed_launch(const PointRow& point, AttemptRow attempt, LaunchTrouble trouble, const std::string& why);
  [[nodiscard]] std::vector<Startable> startables() const;
  [[nodiscard]] Capacity capacity(const Cores& free) const;
  [[nodiscard]] Cores free_cores_now() const;
  [[nodiscard]] const LivingJob* living_job(const std::string& key) const;
  [[nodiscard]] std::filesystem::path run_directory(const std::string& key) const;
  [[nodiscard]] std::string name_of(const PointRow& point);

  std::filesystem::path directory_;
  Say say_;
  CampaignLock lock_;
  Store store_;
  Study study_;
  RetryPolicy policy_;
  Breaker breaker_;
  LocalExecutor executor_;
  Engine engine_;
  std::unique_ptr<SlurmEngine> slurm_;  ///< there if the engine is Slurm or an attempt of it is open
  bool is_new_look_ = false;            ///< Slurm was asked in this pass
  bool has_tested_submission_ = false;
  std::optional<std::int64_t> promised_bytes_;  ///< of this pass: what living jobs may still write, and its starts
  bool waits_for_room_ = false;                 ///< and that was said
  std::filesystem::path solver_;                ///< found when the first job is started
  Cores allowed_;
  std::vector<LivingJob> living_;
  std::map<std::string, std::string> names_;
  std::set<std::string> said_;  ///< warnings are said once
};

}  // namespace rouleau::campaign
