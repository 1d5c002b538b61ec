// SPDX-License-Identifier: BSD-3-Clause
// Bringing one point up to date, in one transaction.
#include "ingest/ingest.hpp"

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
  const LogPart log = read_sample_log(directory / "samples.csv", store.sample_mark(key));
  done.warnings = log.warnings;

  Transaction transaction = store.begin();
  for (const AttemptRow& known : store.attempts(key)) {
    AttemptRow attempt = known;
    fill_from_files(attempt, directory, done.warnings);
    if (!(attempt == known)) store.put_attempt(attempt);
  }
  const bool had_samples = store.sample_mark(key).offset > 0;
  if (log.from_start && (had_samples || !log.rows.empty())) {
    store.delete_samples(key);
    done.reread = true;
  }
  if (done.reread || !log.rows.empty()) {
    store.put_samples(key, log.rows);
    store.set_sample_mark(key, log.mark);
    refresh_results(store, key, stored_analysis(store));
    done.new_samples = static_cast<std::int64_t>(log.rows.size());
  } else if (!(log.mark == store.sample_mark(key))) {
    store.set_sample_mark(key, log.mark);
  }
  transaction.commit();
  return done;
}

}  // namespace rouleau::campaign
