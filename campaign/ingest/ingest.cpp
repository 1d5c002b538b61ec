// SPDX-License-Identifier: BSD-3-Clause
// Bringing one point up to date, in one transaction.
#include "ingest/ingest.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ingest/run_files.hpp"
#include "ingest/sample_log.hpp"
#include "report/analysis.hpp"
#include "study/error.hpp"
#include "study/numbers.hpp"

namespace rouleau::campaign {
namespace {

std::string setting_name(std::string_view name) { return "analysis." + std::string(name); }

void refresh_results(Store& store, std::string_view key, const Analysis& analysis) {
  store.delete_results(key);
  const std::vector<SampleRow> samples = store.samples(key);
  for (const ResultRow& result : analyse(key, samples, analysis)) store.put_result(result);
}

std::filesystem::path log_of(const std::filesystem::path& run_directory) { return run_directory / "samples.csv"; }

/// A log that does not replace what was read of it before: what is wrong, and what to do.
std::string kept_text(const PointRow& point, const std::filesystem::path& file, const LogPart& log,
                      std::size_t stored) {
  const std::string found =
      log.warnings.empty() ? fmt::format("{}: has {} samples", file.string(), log.rows.size()) : log.warnings.front();
  return fmt::format("#{}: {}. The database keeps the {} samples that it has read. {}", point.ordinal, found, stored,
                     point.state == State::done
                         ? "Put the file back from a copy: `rouleau rebuild` would have nothing else to read."
                         : "`rouleau run` goes on from a checkpoint that counts only what is sound.");
}

}  // namespace

PointRow row_of(const Point& point) {
  PointRow row;
  row.key = point.key;
  row.ordinal = point.ordinal;
  row.replica = point.replica;
  row.in_study = point.in_study;
  row.end_step = point.facts.steps;
  row.end_time_s = point.facts.end_time_s;
  return row;
}

std::vector<ParameterRow> parameter_rows_of(const Point& point) {
  std::vector<ParameterRow> rows;
  for (const Parameter& parameter : point.parameters) {
    const bool swept = std::find(point.swept.begin(), point.swept.end(), parameter.name) != point.swept.end();
    rows.push_back({parameter.name, parameter.value, parse_number(parameter.value), swept});
  }
  return rows;
}

Analysis stored_analysis(const Store& store) {
  Analysis analysis;
  for (const SettingRow<Analysis>& row : analysis_rows()) {
    const std::optional<std::string> text = store.setting(setting_name(row.name));
    if (!text) continue;
    const std::optional<double> value = parse_number(*text);
    if (!value)
      fail(Exit::damaged, "{}: setting {} is `{}`, which is no number; `rouleau rebuild` makes the database anew",
           store.database().file().string(), setting_name(row.name), *text);
    analysis.*row.member = *value;
  }
  return analysis;
}

void store_analysis(Store& store, const Analysis& analysis) {
  const Analysis stored = stored_analysis(store);
  Transaction transaction = store.begin();
  bool changed = false;
  for (const SettingRow<Analysis>& row : analysis_rows()) {
    changed = changed || stored.*row.member != analysis.*row.member;
    store.set_setting(setting_name(row.name), shortest(analysis.*row.member));
  }
  if (changed)
    for (const PointRow& point : store.points()) refresh_results(store, point.key, analysis);
  transaction.commit();
}

void fill_from_files(AttemptRow& attempt, const std::filesystem::path& run_directory,
                     std::vector<std::string>& warnings) {
  const std::filesystem::path folder = run_directory / "attempts" / std::to_string(attempt.number);
  std::optional<ProcessFile> process = read_process_file(folder / "process.json", warnings);
  if (!process) process = read_process_file(folder / "started.json", warnings);  // started by hand
  if (process && attempt.pid == 0) {
    attempt.host = process->host;
    attempt.boot_id = process->boot_id;
    attempt.pid = process->pid;
    attempt.start_ticks = process->start_ticks;
    attempt.ranks = process->ranks;
    if (process->checkpoint_step) attempt.checkpoint_at_start = *process->checkpoint_step;
    if (process->started_unix_s) attempt.started_unix_s = *process->started_unix_s;
  }
  if (const std::optional<JobFile> job = read_job_file(folder / "job", warnings)) {
    attempt.engine = slurm_engine;
    attempt.job_id = job->id;
  }
  const std::optional<ExitFile> exit = read_exit_file(folder / "exit.json", warnings);
  if (!exit) return;
  attempt.exit_code = exit->code;
  attempt.reason = exit->reason;
  attempt.resumed_from = exit->resumed_from;
  attempt.start_step = exit->start_step;
  attempt.step = exit->step;
  attempt.wall_s = exit->wall_s;
  attempt.core_s = exit->core_s;
  attempt.mlups = exit->mlups;
  attempt.version = exit->version;
  attempt.git = exit->git;
  if (attempt.host.empty()) attempt.host = exit->host;
  if (attempt.ranks == 0) attempt.ranks = exit->ranks.value_or(0);
  if (!attempt.ended_unix_s) attempt.ended_unix_s = exit->finished_unix_s;
}

Ingested ingest_point(Store& store, const std::filesystem::path& campaign_directory, std::string_view key) {
  Ingested done;
  const std::filesystem::path directory = point_directory(campaign_directory, std::string(key));
  const SampleMark mark = store.sample_mark(key);
  const LogPart log = read_sample_log(log_of(directory), mark);

  Transaction transaction = store.begin();
  for (const AttemptRow& known : store.attempts(key)) {
    AttemptRow attempt = known;
    fill_from_files(attempt, directory, done.warnings);
    if (!(attempt == known)) store.put_attempt(attempt);
  }
  const bool had_samples = mark.offset > 0;
  const std::size_t stored = log.from_start && had_samples ? store.samples(key).size() : 0;
  const std::optional<PointRow> point = store.point(key);
  if (point && !may_replace(log, stored, point->state == State::done)) {
    done.warnings.push_back(kept_text(*point, log_of(directory), log, stored));
    transaction.commit();
    return done;
  }
  done.warnings.insert(done.warnings.end(), log.warnings.begin(), log.warnings.end());
  if (log.from_start && (had_samples || !log.rows.empty())) {
    store.delete_samples(key);
    done.reread = true;
  }
  if (done.reread || !log.rows.empty()) {
    store.put_samples(key, log.rows);
    store.set_sample_mark(key, log.mark);
    refresh_results(store, key, stored_analysis(store));
    done.new_samples = static_cast<std::int64_t>(log.rows.size());
  } else if (!(log.mark == mark)) {
    store.set_sample_mark(key, log.mark);
  }
  transaction.commit();
  return done;
}

std::string sample_trouble(const Store& store, const std::filesystem::path& run_directory, std::string_view key,
                           std::int64_t end_step) {
  const std::filesystem::path file = log_of(run_directory);
  const LogPart log = read_sample_log(file, {});
  if (!log.warnings.empty()) return log.warnings.front();
  if (log.unfinished_bytes > 0)
    return fmt::format("{}: its last {} bytes are no whole line", file.string(), log.unfinished_bytes);
  if (log.rows.empty()) return fmt::format("{}: has no samples", file.string());

  const std::int64_t last = log.rows.back().step;
  // The interval may change between attempts: the study's now, or that of the samples themselves.
  std::int64_t interval = 1;
  for (const ParameterRow& parameter : store.parameters(key))
    if (parameter.name == "output.sample_interval_steps" && parameter.value)
      interval = std::max(interval, static_cast<std::int64_t>(*parameter.value));
  const auto before =
      std::find_if(log.rows.rbegin(), log.rows.rend(), [&](const SampleRow& row) { return row.step != last; });
  if (before != log.rows.rend()) interval = std::max(interval, last - before->step);
  if (end_step - last >= interval)
    return fmt::format("{}: its last sample is that of step {}, the run ended at step {} and samples every {}",
                       file.string(), last, end_step, interval);
  const auto cells_at = [&](std::int64_t step) {
    return std::count_if(log.rows.begin(), log.rows.end(), [&](const SampleRow& row) { return row.step == step; });
  };
  if (const std::int64_t first = log.rows.front().step; cells_at(last) < cells_at(first))
    return fmt::format("{}: has {} cells at step {}, and {} at its last, {}", file.string(), cells_at(first), first,
                       cells_at(last), last);
  return "";
}

int starts_in_vain(const std::vector<AttemptRow>& attempts) {
  const auto others = std::find_if(attempts.rbegin(), attempts.rend(), [&](const AttemptRow& attempt) {
    return attempt.checkpoint_at_start != attempts.back().checkpoint_at_start;
  });
  return static_cast<int>(others - attempts.rbegin());
}

}  // namespace rouleau::campaign
