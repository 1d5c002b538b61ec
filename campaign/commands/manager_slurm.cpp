// SPDX-License-Identifier: BSD-3-Clause
// The manager's side of Slurm: which engine, one look a pass, and what a look means for an attempt.
#include <algorithm>

#include "commands/manager.hpp"
#include "executor/attempt.hpp"
#include "study/error.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

constexpr double local_pass_interval_s = 0.25;
constexpr const char* engine_file = "engine";

std::string text_of(const Engine& engine) {
  return engine.name + (engine.self_sustaining ? " self-sustaining\n" : "\n");
}

}  // namespace

void Manager::open_slurm(const std::filesystem::path& cluster) {
  // Jobs that were submitted are followed to their ends even if their cluster file is gone.
  const bool has_file = std::filesystem::exists(cluster);
  if (!has_file && engine_.name == slurm_engine) {
    fail(Exit::usage,
         "{}: is missing, and the engine is slurm. `rouleau run --engine slurm --cluster FILE` copies one there; "
         "share/clusters/ holds templates.",
         cluster.string());
  }
  slurm_ = std::make_unique<SlurmEngine>(has_file ? read_cluster(cluster) : Cluster{});
}

void Manager::use_engine(const Engine& engine, const std::filesystem::path& cluster) {
  engine_ = engine;
  if (engine_.name == slurm_engine) open_slurm(cluster);
}

void Manager::keep_engine() { write_whole_file(directory_ / engine_file, text_of(engine_)); }

void Manager::read_engine() {
  const std::filesystem::path file = directory_ / engine_file;
  if (const std::optional<std::string> kept = read_whole_file(file, largest_record)) {
    const std::string local(local_engine), slurm(slurm_engine);
    for (const Engine& engine : {Engine{local, false}, Engine{slurm, false}, Engine{slurm, true}}) {
      if (text_of(engine) != *kept) continue;
      engine_ = engine;
      return;
    }
    fail(Exit::damaged,
         "{}: names no engine. Remove it, then say by `rouleau run --engine` whether jobs run here or under Slurm.",
         file.string());
  }
  // Campaigns of earlier versions kept it in the database, which a rebuild cannot restore.
  const std::optional<std::string> name = store_.setting("engine");
  engine_ = {name.value_or(study_.execution.engine), store_.setting("self_sustaining") == "1"};
  if (name) keep_engine();
}

void Manager::look_at_queue() {
  is_new_look_ = slurm_ && slurm_->look();
  if (is_new_look_ && !slurm_->trouble().empty())
    warn_of({fmt::format("{}. Nothing is concluded from that; it is asked again.", slurm_->trouble())});
  if (is_new_look_) cancel_orphans();
}

void Manager::cancel_orphans() {
  for (const JobRow& job : slurm_->held_jobs()) {
    const std::optional<AttemptRow> attempt = store_.attempt_with_token(job.name.substr(job_name_prefix.size()));
    if (!attempt || attempt->state != AttemptState::ended) continue;  // of another campaign, or still followed
    const std::string trouble = slurm_->client().cancel(job.id);
    say_(fmt::format("job {} became visible after its point was submitted anew; {}", job.id,
                     trouble.empty() ? "it is cancelled" : trouble));
  }
}

LifeOf Manager::life_of_attempt(const AttemptRow* row) const {
  return {[this](const ProcessIdentity& process) { return executor_.life(process); },
          [this, row](const JobAttempt& attempt) {
            if (!slurm_) return life_by_files().job(attempt);
            const bool is_its_row = row != nullptr && row->number == attempt.number;
            return slurm_->life(attempt, is_its_row ? row : nullptr);
          }};
}

Gathered Manager::gather_of(const PointRow& point, const AttemptRow* newest) const {
  return gather(run_directory(point.key), newest, life_of_attempt(newest));
}

double Manager::pass_interval_s() const {
  const bool only_slurm = engine_.name == slurm_engine && !has_local_jobs();
  return only_slurm ? slurm_->cluster().poll_s : local_pass_interval_s;
}

void Manager::write_job_file(const AttemptRow& attempt, const JobFile& job) const {
  write_whole_file(attempt_directory(run_directory(attempt.point), attempt.number) / "job",
                   fmt::format("slurm {} {}\n", job.id.empty() ? "-" : job.id, job.name));
}

/// A job that runs finds the stop file; one that waits is taken out of the queue, unless other points wait in it, too.
void Manager::leave_queue(const AttemptRow& attempt, const Gathered& gathered) {
  if (!gathered.is_waiting || attempt.job_id.empty()) return;
  const std::vector<AttemptRow> open = store_.open_attempts();
  const auto is_of_job = [&](const AttemptRow& other) { return other.job_id == attempt.job_id; };
  if (std::count_if(open.begin(), open.end(), is_of_job) > 1) return;
  if (const std::string trouble = slurm_->client().cancel(attempt.job_id); !trouble.empty())
    warn_of({fmt::format("job {}: {}; it will end itself when it starts", attempt.job_id, trouble)});
}

void Manager::follow_job(const PointRow& point, AttemptRow* newest, const Gathered& gathered) {
  const std::string id = gathered.job->id.empty() ? slurm_->id_of(gathered.job->name) : gathered.job->id;
  std::string trouble;
  if (gathered.action == JobAction::cancel && !id.empty()) trouble = slurm_->client().cancel(id);
  if (gathered.action == JobAction::release) trouble = slurm_->client().release(id);
  if (!trouble.empty()) warn_of({fmt::format("{}: job {}: {}", name_of(point), id, trouble)});

  const bool is_its_row = newest != nullptr && newest->number == gathered.evidence.newest_attempt;
  if (!is_its_row || newest->state == AttemptState::ended) return;
  const AttemptRow before = *newest;
  // Found by name after a manager died behind its submission.
  if (gathered.job->id.empty() && !id.empty()) write_job_file(*newest, {id, gathered.job->name});
  if (!id.empty()) newest->job_id = id;
  const bool was_released = gathered.action == JobAction::release && trouble.empty();
  if (was_released || gathered.is_shown) newest->state = AttemptState::launched;
  if (is_new_look_ && !gathered.evidence.engine_words.empty()) newest->job_state = gathered.evidence.engine_words;
  if (!(before == *newest)) store_.put_attempt(*newest);
}

}  // namespace rouleau::campaign
