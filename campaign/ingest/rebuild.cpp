// SPDX-License-Identifier: BSD-3-Clause
// Points from point.json, states by replaying the attempts.
#include "ingest/rebuild.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "ingest/ingest.hpp"
#include "ingest/run_files.hpp"
#include "study/error.hpp"

namespace rouleau::campaign {
namespace {

/// Of a file that may be gone: 0 then.
double modified_unix_s(const std::filesystem::path& file) {
  std::error_code error;
  const auto time = std::filesystem::last_write_time(file, error);
  if (error) return 0;
  const auto system = std::chrono::file_clock::to_sys(time);
  return std::chrono::duration<double>(system.time_since_epoch()).count();
}

/// Puts the events of one point back in their order, and ends in its state.
class Replay {
 public:
  Replay(Store& store, const Point& point, const std::filesystem::path& directory, const RetryPolicy& policy)
      : store_(store), point_(point), directory_(directory), policy_(policy) {}

  /// returns  the number of attempts
  int attempts(const AttemptLife& life_of, std::vector<std::string>& warnings) {
    std::vector<AttemptRow> rows = attempt_rows(warnings);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const bool is_newest = i + 1 == rows.size();
      Evidence evidence;
      evidence.newest_attempt = rows[i].number;
      if (rows[i].pid != 0 || !rows[i].job_id.empty()) evidence.life = is_newest ? life_of(rows[i]) : Life::dead;
      if (rows[i].exit_code)
        evidence.exit =
            ExitRecord{*rows[i].exit_code, rows[i].reason, rows[i].start_step.value_or(0), rows[i].step.value_or(0)};
      const std::vector<std::int64_t> checkpoints = checkpoint_steps(directory_);
      if (!is_newest)
        evidence.newest_checkpoint = rows[i + 1].checkpoint_at_start;
      else if (!checkpoints.empty())
        evidence.newest_checkpoint = checkpoints.back();
      // How long the run was meant to be in earlier attempts is not known: 0.
      one_attempt(rows[i], evidence, is_newest ? point_.facts.steps : 0);
    }
    return static_cast<int>(rows.size());
  }

  void decisions() {
    if (point_.cancelled) go_to(State::cancelled, "the user cancelled it", {});
    store_.set_retry(point_.key, retries_used_, 0);
  }

 private:
  std::vector<AttemptRow> attempt_rows(std::vector<std::string>& warnings) const {
    std::vector<AttemptRow> rows;
    for (const int number : attempt_numbers(directory_)) {
      const std::filesystem::path owner = directory_ / "attempts" / std::to_string(number) / "owner";
      AttemptRow row;
      row.point = point_.key;
      row.number = number;
      row.token = read_first_line(owner).value_or("");
      row.started_unix_s = modified_unix_s(owner);
      fill_from_files(row, directory_, warnings);
      // Without the launcher's word, an attempt started from what it resumed, or from what the one before did.
      if (row.checkpoint_at_start < 0 && row.start_step.value_or(0) > 0) row.checkpoint_at_start = *row.start_step;
      if (row.checkpoint_at_start < 0 && !row.start_step && !rows.empty())
        row.checkpoint_at_start = rows.back().checkpoint_at_start;
      rows.push_back(row);
    }
    return rows;
  }

  void one_attempt(AttemptRow& row, Evidence& evidence, std::int64_t end_step) {
    if (is_final(state_)) retries_used_ = 0;  // only a user's retry leads on from here
    go_to(State::running, fmt::format("attempt {} was started", row.number), row.started_unix_s, row.number);
    const Recorded recorded{State::running, row.number, true, row.checkpoint_at_start, retries_used_, end_step};
    Verdict verdict = judge(recorded, evidence, policy_);
    if (verdict.state == State::done && end_step > 0) {  // of earlier attempts the log holds what the last one left
      evidence.sample_trouble = sample_trouble(store_, directory_, point_.key, evidence.exit->step);
      verdict = judge(recorded, evidence, policy_);
    }
    row.state = verdict.attempt_ended ? AttemptState::ended : AttemptState::launched;
    store_.put_attempt(row);
    retries_used_ = verdict.retries_used;
    if (verdict.state != state_) go_to(verdict.state, verdict.evidence, row.ended_unix_s, row.number);
    if (point_.retried_after == row.number && state_ != State::running && state_ != State::done) {
      retries_used_ = 0;
      const bool has_checkpoint = !checkpoint_steps(directory_).empty();
      go_to(has_checkpoint ? State::stopped : State::waiting, "the user asked for a retry", {});
    }
  }

  void go_to(State to, const std::string& evidence, std::optional<double> unix_s, std::optional<int> attempt = {}) {
    store_.change_state(point_.key, state_, to, evidence + " (reconstructed from the run directory)", attempt, unix_s);
    state_ = to;
  }

  Store& store_;
  const Point& point_;
  const std::filesystem::path& directory_;
  const RetryPolicy& policy_;
  State state_ = State::waiting;
  int retries_used_ = 0;
};

/// All points whose point.json can be read, by ordinal.   throws Error if `points` cannot be listed, or is not there: a
/// database without points is no index of them
std::vector<Point> points_of(const std::filesystem::path& campaign_directory, std::vector<std::string>& warnings) {
  const std::filesystem::path folder = campaign_directory / "points";
  if (!std::filesystem::is_directory(folder))
    fail(Exit::not_found,
         "{}: there is no such folder, and nothing else to make the database from. See that its disk is mounted.",
         folder.string());
  std::vector<Point> points;
  for (const auto& entry : entries_of(folder)) {
    std::error_code unseen;
    if (!entry.is_directory(unseen)) {
      if (unseen) warnings.push_back(fmt::format("{}: cannot be seen: {}", entry.path().string(), unseen.message()));
      continue;
    }
    try {
      Point point = read_point(entry.path() / "point.json");
      // With folders that cannot be listed it would come back as a point that was never started.
      static_cast<void>(attempt_numbers(entry.path()));
      static_cast<void>(checkpoint_steps(entry.path()));
      if (point.key != entry.path().filename())
        warnings.push_back(
            fmt::format("{}: its point.json is that of {}; left aside", entry.path().string(), point.key));
      else
        points.push_back(std::move(point));
    } catch (const Error& damage) {
      warnings.push_back(damage.what());
    }
  }
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return std::pair(a.ordinal, a.key) < std::pair(b.ordinal, b.key); });
  return points;
}

}  // namespace

Rebuilt rebuild_store(const std::filesystem::path& campaign_directory, const std::filesystem::path& file,
                      const CampaignRow& campaign, const Study& study, const AttemptLife& life_of) {
  Rebuilt rebuilt;
  Store store = Store::create(file, campaign);
  Transaction transaction = store.begin();
  store_analysis(store, study.analysis);
  const RetryPolicy policy{static_cast<int>(study.execution.retries), study.execution.retry_delay_s,
                           study.execution.io_retry_delay_s};
  std::set<int> ordinals;
  for (const Point& point : points_of(campaign_directory, rebuilt.warnings)) {
    const std::filesystem::path directory = point_directory(campaign_directory, point.key);
    if (!ordinals.insert(point.ordinal).second) {
      rebuilt.warnings.push_back(
          fmt::format("{}: ordinal {} is taken by another point; left aside", directory.string(), point.ordinal));
      continue;
    }
    // run.ini is the first thing that a point has, and is hardly ever written again.
    const double since_unix_s = modified_unix_s(directory / "run.ini");
    store.add_point(row_of(point), parameter_rows_of(point), "found in the campaign's directory by a rebuild",
                    since_unix_s > 0 ? std::optional(since_unix_s) : std::nullopt);
    Replay replay(store, point, directory, policy);
    rebuilt.attempts += replay.attempts(life_of, rebuilt.warnings);
    replay.decisions();
    const Ingested ingested = ingest_point(store, campaign_directory, point.key);
    rebuilt.samples += ingested.new_samples;
    rebuilt.warnings.insert(rebuilt.warnings.end(), ingested.warnings.begin(), ingested.warnings.end());
    ++rebuilt.points;
  }
  transaction.commit();
  // A damaged file is met more than once on the way.
  std::set<std::string> said;
  std::erase_if(rebuilt.warnings, [&](const std::string& warning) { return !said.insert(warning).second; });
  return rebuilt;
}

}  // namespace rouleau::campaign
