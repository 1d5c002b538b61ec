// SPDX-License-Identifier: BSD-3-Clause
// Submitting: intents recorded, attempts claimed, job submitted held, its id recorded, job released. After a kill
// between any two of these the next pass finds the job by its name.
#include <algorithm>
#include <set>

#include "commands/manager.hpp"
#include "commands/pause.hpp"
#include "executor/attempt.hpp"
#include "executor/solver.hpp"
#include "study/error.hpp"
#include "study/input_files.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

constexpr const char* end_pass_patience_s = "600";

std::filesystem::path this_program() { return std::filesystem::read_symlink("/proc/self/exe"); }

}  // namespace

std::vector<std::vector<PointRow>> Manager::next_packs() const {
  const Cluster& cluster = slurm_->cluster();
  std::set<std::string> jobs;
  for (const LivingJob& job : living_) {
    if (job.job) jobs.insert(job.job->name);
  }
  const auto points_per_job = static_cast<int>(cluster.points_per_job);
  const int slots = std::min(static_cast<int>(cluster.jobs) - static_cast<int>(jobs.size()),
                             static_cast<int>(cluster.submissions_per_pass));
  Capacity capacity;
  capacity.jobs = static_cast<int>(living_.size()) + std::max(0, slots) * points_per_job;
  capacity.oversubscribe = true;  // the cores are Slurm's business
  std::vector<std::vector<PointRow>> packs;
  for (const std::string& key : choose_starts(startables(), capacity, now_unix_s())) {
    if (packs.empty() || static_cast<int>(packs.back().size()) == points_per_job) packs.emplace_back();
    packs.back().push_back(store_.point(key).value());
  }
  return packs;
}

JobScript Manager::script_of(const std::vector<AttemptRow>& attempts) {
  if (solver_.empty()) solver_ = find_solver();
  JobScript script;
  script.solver = solver_;
  script.campaign = directory_;
  script.name = std::string(job_name_prefix) + attempts.front().token;
  script.ranks = attempts.front().ranks;
  for (const AttemptRow& attempt : attempts) script.points.push_back({attempt.point, attempt.number, attempt.token});
  if (engine_.self_sustaining)
    script.at_end = {this_program(), "sync", "--quiet", "--lock-patience-s", end_pass_patience_s, directory_};
  return script;
}

AttemptRow Manager::planned_job_attempt(const PointRow& point) const {
  AttemptRow attempt = planned_attempt(point, {});
  attempt.engine = slurm_engine;
  attempt.host.clear();  // Slurm chooses it
  attempt.job_state = submitted_word;
  const double ranks = slurm_->cluster().ranks;
  if (ranks > 0) attempt.ranks = static_cast<int>(ranks);
  return attempt;
}

bool Manager::test_submission(const JobScript& script) {
  if (has_tested_submission_) return true;
  const ScratchDirectory scratch;
  write_whole_file(scratch.path() / "job.sh", job_script(slurm_->cluster(), script));
  const Submission test = slurm_->client().test_only(scratch.path() / "job.sh");
  if (test.transient) {
    warn_of({fmt::format("nothing is submitted: {}", test.trouble)});
    return false;
  }
  if (!test.trouble.empty()) {
    fail(Exit::usage,
         "{}: Slurm refuses such a job: {}. Nothing was submitted; correct the file (`rouleau engine check` tries it).",
         cluster_file(directory_).string(), test.trouble);
  }
  has_tested_submission_ = true;
  return true;
}

std::vector<std::string> Manager::scripts() {
  std::vector<std::string> texts;
  if (engine_.name != slurm_engine) return texts;
  for (const std::vector<PointRow>& pack : next_packs()) {
    std::vector<AttemptRow> attempts;
    for (const PointRow& point : pack) {
      attempts.push_back(planned_job_attempt(point));
      fit_to_directory(attempts.back());
    }
    texts.push_back(job_script(slurm_->cluster(), script_of(attempts)));
  }
  return texts;
}

int Manager::submit() {
  if (!slurm_->trouble().empty()) return 0;  // silent in this pass; said already
  int submitted = 0;
  for (std::vector<PointRow>& pack : next_packs()) {
    const int points = static_cast<int>(pack.size());
    if (!submit_pack(std::move(pack))) break;
    submitted += points;
    if (is_paused()) break;
  }
  return submitted;
}

void Manager::claim_pack(const std::vector<PointRow>& points, const std::vector<AttemptRow>& attempts,
                         const JobScript& script) {
  Transaction intent = store_.begin();
  for (std::size_t i = 0; i < points.size(); ++i) {
    store_.put_attempt(attempts[i]);
    const std::string evidence = fmt::format("attempt {} is submitted to Slurm", attempts[i].number);
    if (!store_.change_state(points[i].key, points[i].state, State::running, evidence, attempts[i].number))
      fail(Exit::failed, "point {} changed its state while it was being submitted. Run `rouleau sync` again.",
           points[i].key);
  }
  intent.commit();
  const std::string text = job_script(slurm_->cluster(), script);
  for (const AttemptRow& attempt : attempts) {
    const std::filesystem::path run = run_directory(attempt.point);
    remove_stop_file(run);
    claim_attempt(run, attempt.number, attempt.token);
    write_job_file(attempt, {"", script.name});
    write_whole_file(attempt_directory(run, attempt.number) / "job.sh", text);
  }
}

bool Manager::submit_pack(std::vector<PointRow> points) {
  std::vector<AttemptRow> attempts;
  std::erase_if(points, [&](const PointRow& point) {
    AttemptRow attempt = planned_job_attempt(point);
    try {
      fit_to_directory(attempt);
      if (!take_room_for(point)) return true;
      require_input_files(run_directory(point.key), read_point(run_directory(point.key) / "point.json"));
    } catch (const Error& error) {
      record_failed_launch(point, attempt, trouble_of(error), error.what());
      return true;
    }
    attempts.push_back(attempt);
    return false;
  });
  if (points.empty()) return false;
  const JobScript script = script_of(attempts);
  if (!test_submission(script)) return false;
  Submission submission;
  LaunchTrouble kind = LaunchTrouble::files;
  try {
    claim_pack(points, attempts, script);
    kind = LaunchTrouble::engine;
    submission =
        slurm_->client().submit_held(attempt_directory(run_directory(points[0].key), attempts[0].number) / "job.sh");
  } catch (const DatabaseError&) {
    throw;  // the intents were not recorded, and nothing is submitted without
  } catch (const Error& error) {
    submission.trouble = error.what();
  }
  if (submission.id.empty() && !submission.transient) {
    for (std::size_t i = 0; i < points.size(); ++i)
      record_failed_launch(points[i], attempts[i], kind, submission.trouble);
    return false;
  }
  // Whether a submission without an answer arrived is not known; the next passes look for its name.
  for (std::size_t i = 0; i < points.size(); ++i) {
    LivingJob& job = living_.emplace_back();
    job.key = points[i].key;
    job.ordinal = points[i].ordinal;
    job.attempt = attempts[i].number;
    job.ranks = attempts[i].ranks;
    job.job = JobFile{submission.id, script.name};
    job.words = "submitted";
  }
  if (submission.id.empty()) {
    warn_of({fmt::format("{}: sbatch: {}; it is looked for", name_of(points.front()), submission.trouble)});
    return false;
  }
  for (const AttemptRow& attempt : attempts) write_job_file(attempt, {submission.id, script.name});
  const std::string trouble = slurm_->client().release(submission.id);
  Transaction outcome = store_.begin();
  for (AttemptRow& attempt : attempts) {
    attempt.job_id = submission.id;
    if (trouble.empty()) attempt.state = AttemptState::launched;
    store_.put_attempt(attempt);
  }
  outcome.commit();
  if (!trouble.empty())
    warn_of({fmt::format("job {} is held still: {}; it is released later", submission.id, trouble)});
  const std::string others = points.size() > 1 ? fmt::format(" and {} more", points.size() - 1) : "";
  say_(fmt::format("{}{}: submitted as job {} of Slurm", name_of(points.front()), others, submission.id));
  return true;
}

}  // namespace rouleau::campaign
