// SPDX-License-Identifier: BSD-3-Clause
// `rouleau status`: a line a point, from the database and from what the run directories say at this moment.
#include <algorithm>
#include <map>
#include <ostream>

#include "commands/duration.hpp"
#include "commands/evidence.hpp"
#include "commands/pause.hpp"
#include "commands/print.hpp"
#include "commands/verbs.hpp"
#include "ingest/run_files.hpp"
#include "report/columns.hpp"
#include "study/numbers.hpp"
#include "study/point.hpp"

namespace rouleau::campaign {

namespace {

namespace po = boost::program_options;

/// What a line of the listing says.
struct PointStatus {
  PointRow point;
  std::vector<Value> swept;
  std::optional<ProgressFile> progress;
  std::int64_t step = 0;
  int attempts = 0;
  bool lives = false;
  bool is_queued = false;  ///< handed to Slurm, which has not started it yet
  std::string note;
};

/// What the database knows of all points, read at once: a query a point would take seconds for ten thousand.
struct Known {
  std::map<std::string, std::vector<ParameterRow>> swept;
  std::map<std::string, AttemptRow> newest;
};

/// What the run directory says at this moment.
void look_at(PointStatus& status, const std::filesystem::path& run, const AttemptRow* newest) {
  std::vector<std::string> warnings;
  const PointRow& point = status.point;
  status.progress = read_progress_file(run / "progress.json", warnings);
  status.step = std::max(status.progress ? status.progress->step : 0, newest ? newest->step.value_or(0) : 0);

  // The record may be older than the truth: a manager that was killed cannot have noted the end of its jobs.
  const Gathered gathered = gather(run, status.attempts, life_by_files());
  const bool is_open = newest && newest->state != AttemptState::ended;
  status.lives = gathered.evidence.life == Life::alive &&
                 (!gathered.job || (is_open && status.progress && status.progress->attempt == newest->number));
  status.is_queued = point.state == State::running && gathered.job && is_open &&
                     gathered.evidence.life == Life::alive && !status.lives &&
                     !newest->job_state.starts_with("running");
  const Verdict verdict = judge(recorded_of(point, newest), gathered.evidence, RetryPolicy{});
  if (verdict.state != point.state)
    status.note = fmt::format("now {}: `rouleau run` or `sync` takes note", word_of(verdict.state));
  else if (!point.in_study)
    status.note = "no longer in the study";
  else if (is_open && !newest->job_id.empty())
    status.note = fmt::format("job {}: {}", newest->job_id, newest->job_state);
  else if (newest && !newest->reason.empty() && point.state != State::done && point.state != State::running)
    status.note = newest->reason;
  for (const std::string& warning : warnings) status.note += (status.note.empty() ? "" : "; ") + warning;
}

PointStatus status_of(const Known& known, const std::filesystem::path& campaign, const PointRow& point) {
  PointStatus status;
  status.point = point;
  if (const auto swept = known.swept.find(point.key); swept != known.swept.end()) {
    for (const ParameterRow& row : swept->second)
      status.swept.push_back(row.value ? Value(*row.value) : Value(row.text));
  }
  const auto found = known.newest.find(point.key);
  const AttemptRow* newest = found == known.newest.end() ? nullptr : &found->second;
  status.attempts = newest ? newest->number : 0;
  const std::filesystem::path run = point_directory(campaign, point.key);
  const bool was_started = newest || std::filesystem::exists(run / "attempts");
  if (was_started) look_at(status, run, newest);
  if (!was_started && !point.in_study) status.note = "no longer in the study";
  return status;
}

/// For people: a point that waits in Slurm's queue does not run.
std::string state_word(const PointStatus& status) {
  return status.is_queued ? "queued" : std::string(word_of(status.point.state));
}

double fraction_of(const PointStatus& status) {
  return status.point.end_step > 0 ? static_cast<double>(status.step) / static_cast<double>(status.point.end_step) : 0;
}

Value number(const std::optional<double>& value) { return value ? Value(*value) : Value(); }

/// For programs: raw numbers.
std::vector<Value> exact_row(const PointStatus& s, double now) {
  const std::optional<ProgressFile>& p = s.progress;
  std::vector<Value> row = {std::int64_t{s.point.ordinal}, s.point.key};
  row.insert(row.end(), s.swept.begin(), s.swept.end());
  const bool has_checkpoint = p && p->checkpoint_step && p->checkpoint_unix_s;
  const std::vector<Value> rest = {std::string(word_of(s.point.state)),
                                   s.step,
                                   s.point.end_step,
                                   fraction_of(s),
                                   s.lives && p ? number(p->steps_per_s) : Value(),
                                   s.lives && p ? number(p->mlups) : Value(),
                                   s.lives && p ? number(p->eta_s) : Value(),
                                   has_checkpoint ? Value(*p->checkpoint_step) : Value(),
                                   has_checkpoint ? Value(now - *p->checkpoint_unix_s) : Value(),
                                   p ? number(p->d_um) : Value(),
                                   p ? number(p->asphericity) : Value(),
                                   std::int64_t{s.attempts},
                                   s.note};
  row.insert(row.end(), rest.begin(), rest.end());
  return row;
}

const std::vector<std::string> exact_columns = {"state",
                                                "step",
                                                "end_step",
                                                "fraction",
                                                "steps_per_s",
                                                "mlups",
                                                "eta_s",
                                                "checkpoint_step",
                                                "checkpoint_age_s",
                                                "d_um",
                                                "asphericity",
                                                "attempts",
                                                "note"};

/// For eyes: durations and per cent.
std::vector<Value> short_row(const PointStatus& s, double now) {
  const std::optional<ProgressFile>& p = s.progress;
  std::vector<Value> row = {fmt::format("#{}", s.point.ordinal)};
  row.insert(row.end(), s.swept.begin(), s.swept.end());
  const std::vector<Value> rest = {state_word(s),
                                   fmt::format("{:.0f} %", std::min(100.0, 100 * fraction_of(s))),
                                   s.lives && p && p->mlups ? Value(fmt::format("{:.1f}", *p->mlups)) : Value(),
                                   s.lives && p && p->eta_s ? Value(duration_text(*p->eta_s)) : Value(),
                                   s.lives && p && p->checkpoint_unix_s && p->checkpoint_step
                                       ? Value(duration_text(now - *p->checkpoint_unix_s) + " ago")
                                       : Value(),
                                   p && p->d_um ? Value(fmt::format("{:.3f}", *p->d_um)) : Value(),
                                   std::int64_t{s.attempts},
                                   s.note};
  row.insert(row.end(), rest.begin(), rest.end());
  return row;
}

const std::vector<std::string> short_columns = {"state",      "done", "MLUPS",    "left",
                                                "checkpoint", "d/um", "attempts", "note"};

/// "quick: 7 points: 3 done, 2 running, 2 waiting; about 2 h 10 min left"
std::string summary(const CampaignRow& campaign, const std::vector<PointStatus>& all) {
  std::map<std::pair<State, bool>, int> counts;  // of each state, in Slurm's queue or not
  double remaining_s = 0, speed = 0;
  int living = 0;
  for (const PointStatus& s : all) {
    ++counts[{s.point.state, s.is_queued}];
    if (!s.lives || !s.progress || s.progress->steps_per_s.value_or(0) <= 0) continue;
    ++living;
    speed += *s.progress->steps_per_s;
  }
  std::string text;
  for (const auto& [state, count] : counts)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, state.second ? "queued" : word_of(state.first));
  text = fmt::format("{}: {} point{}: {}", campaign.name, all.size(), all.size() == 1 ? "" : "s", text);
  if (living == 0) return text;
  // Points that do not run yet are taken to go at the mean speed of those that do, as many at a time.
  for (const PointStatus& s : all)
    if (!is_final(s.point.state) && s.point.in_study)
      remaining_s += static_cast<double>(std::max<std::int64_t>(0, s.point.end_step - s.step)) / speed;
  return text + fmt::format("; about {} left with {} running", duration_text(remaining_s), living);
}

void describe(po::options_description& options) {
  options.add_options()("exit-code", po::bool_switch(), "end with 4 if points failed, were refused or are exhausted");
}

int status(const CommandLine& line) {
  const Store store = Store::open_reader(line.directory / "campaign.db");
  const double now = now_unix_s();
  std::vector<PointStatus> all;
  const Known known{store.swept_parameters(), store.newest_attempts()};
  for (const PointRow& point : store.points()) all.push_back(status_of(known, line.directory, point));

  const bool for_eyes = line.format == Format::table;
  Table table{"status", {for_eyes ? "point" : "ordinal"}, {}};
  if (!for_eyes) table.columns.push_back("key");
  const Columns columns(store);
  for (const std::string& name : columns.swept()) table.columns.push_back(columns.short_name(columns.find(name)));
  const std::vector<std::string>& rest = for_eyes ? short_columns : exact_columns;
  table.columns.insert(table.columns.end(), rest.begin(), rest.end());
  for (PointStatus& s : all) {
    s.swept.resize(columns.swept().size());  // a point of an earlier study may lack a later axis
    table.rows.push_back(for_eyes ? short_row(s, now) : exact_row(s, now));
  }
  print(line, table);
  const CampaignRow campaign = store.campaign();
  if (!line.quiet) line.io.err << summary(campaign, all) << '\n';
  const Breaker breaker = kept_breaker(store, parse_study(campaign.study_text, line.directory / "study.ini"));
  if (breaker.has_tripped()) line.io.err << pause_text(breaker) << '\n';
  const bool some_failed = std::any_of(all.begin(), all.end(), [](const PointStatus& s) {
    return s.point.state == State::failed || s.point.state == State::refused || s.point.state == State::exhausted;
  });
  return static_cast<int>(line.is_set("exit-code") && some_failed ? Exit::some_failed : Exit::ok);
}

}  // namespace

const Verb status_verb = {
    "status",
    "how far each point is",
    "[DIR] [--format F] [--exit-code]",
    "  rouleau status my-campaign                 a line a point, a summary on stderr\n"
    "  rouleau status my-campaign --format json   for programs\n"
    "  watch rouleau status my-campaign           every two seconds\n",
    "Reads only, and works while `rouleau run` runs. `left` and `MLUPS` are those of running jobs; `d/um` is the last\n"
    "displacement. States: waiting, queued (by Slurm), running, stopped (will be continued), done,\n"
    "failed (physics), refused (bad input),\n"
    "crashed (will be retried), exhausted (retries used up), cancelled.\n",
    Words::campaign,
    true,
    describe,
    status,
};

}  // namespace rouleau::campaign
