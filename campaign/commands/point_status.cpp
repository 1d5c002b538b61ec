// SPDX-License-Identifier: BSD-3-Clause
// Records, weighed against what the run directories prove.
#include "commands/point_status.hpp"

#include <algorithm>
#include <utility>

#include "commands/evidence.hpp"
#include "ingest/run_files.hpp"
#include "study/error.hpp"
#include "study/point.hpp"

namespace rouleau::campaign {

namespace {

/// The values of the axes, by name: a point of an earlier study may lack a later axis.
std::vector<Value> values_of(const std::vector<ParameterRow>& parameters, const std::vector<std::string>& axes) {
  std::vector<Value> values(axes.size());
  for (const ParameterRow& row : parameters) {
    const auto axis = std::find(axes.begin(), axes.end(), row.name);
    if (axis != axes.end())
      values[static_cast<std::size_t>(axis - axes.begin())] = row.value ? Value(*row.value) : Value(row.text);
  }
  return values;
}

/// What the run directory says at this moment.
void look_at(PointStatus& status, const std::filesystem::path& run, const AttemptRow* newest) {
  std::vector<std::string> warnings;
  const PointRow& point = status.point;
  status.progress = read_progress_file(run / "progress.json", warnings);
  status.step = std::max(status.progress ? status.progress->step : 0, newest ? newest->step.value_or(0) : 0);

  // The record may be older than the truth: a manager that was killed cannot have noted the end of its jobs.
  const Gathered gathered = gather(run, newest, life_by_files());
  const bool is_open = newest && newest->state != AttemptState::ended;
  status.lives = gathered.evidence.life == Life::alive &&
                 (!gathered.job || (is_open && status.progress && status.progress->attempt == newest->number));
  status.is_queued = point.state == State::running && gathered.job && is_open &&
                     gathered.evidence.life == Life::alive && !status.lives &&
                     !newest->job_state.starts_with("running");
  status.ranks = std::max(gathered.ranks, newest ? newest->ranks : 1);
  if (status.lives)
    status.steps_of_life =
        std::max<std::int64_t>(0, status.step - std::max<std::int64_t>(0, newest ? newest->checkpoint_at_start : 0));
  const Verdict verdict = judge(recorded_of(point, newest), gathered.evidence, RetryPolicy{});
  status.is_behind = verdict.state != point.state;
  if (status.is_behind)
    status.note = fmt::format("now {}: `rouleau run` or `sync` takes note", word_of(verdict.state));
  else if (!point.in_study)
    status.note = "no longer in the study";
  else if (is_open && !newest->job_id.empty())
    // "submitted" is our own word of a job that nobody has looked for yet; one that computes is beyond it.
    status.note = status.lives && newest->job_state == submitted_word
                      ? "job " + newest->job_id
                      : fmt::format("job {}: {}", newest->job_id, newest->job_state);
  else if (newest && !newest->reason.empty() && point.state != State::done && point.state != State::running)
    status.note = newest->reason;
  for (const std::string& warning : warnings) status.note += (status.note.empty() ? "" : "; ") + warning;
}

}  // namespace

double PointStatus::fraction() const {
  return point.end_step > 0 ? static_cast<double>(step) / static_cast<double>(point.end_step) : 0;
}

double PointStatus::speed() const { return lives && progress ? progress->steps_per_s.value_or(0) : 0; }

std::string PointStatus::state_word() const { return is_queued ? "queued" : std::string(word_of(point.state)); }

std::int64_t PointStatus::steps_left() const {
  return is_final(point.state) || !point.in_study ? 0 : std::max<std::int64_t>(0, point.end_step - step);
}

std::vector<PointStatus> StatusReader::read(const Store& store, const std::vector<std::string>& axes) {
  // All at once: a query a point would take seconds for ten thousand.
  const std::map<std::string, std::vector<ParameterRow>> swept = store.swept_parameters();
  const std::map<std::string, AttemptRow> newest = store.newest_attempts();
  std::vector<PointStatus> all;
  for (const PointRow& point : store.points()) {
    const auto attempt = newest.find(point.key);
    PointStatus& status = all.emplace_back(status_of(point, attempt == newest.end() ? nullptr : &attempt->second));
    const auto parameters = swept.find(point.key);
    status.swept = values_of(parameters == swept.end() ? std::vector<ParameterRow>{} : parameters->second, axes);
  }
  return all;
}

PointStatus StatusReader::status_of(const PointRow& point, const AttemptRow* newest) {
  const auto settled = settled_.find(point.key);
  if (settled != settled_.end() && newest && settled->second.point == point && settled->second.newest == *newest)
    return settled->second.status;
  PointStatus status;
  status.point = point;
  status.attempts = newest ? newest->number : 0;
  const std::filesystem::path run = point_directory(campaign_, point.key);
  try {
    if (newest || !attempt_numbers(run).empty())
      look_at(status, run, newest);
    else if (!point.in_study)
      status.note = "no longer in the study";
  } catch (const std::exception& trouble) {  // one that cannot be seen hides none of the others
    status.note = trouble.what();
    return status;
  }
  // Nothing but a new attempt changes it now, and that is recorded before it starts.
  if (newest && newest->state == AttemptState::ended && is_final(point.state) && !status.lives && !status.is_behind)
    settled_.insert_or_assign(point.key, Settled{point, *newest, status});
  return status;
}

std::string states_text(const std::vector<PointStatus>& points) {
  std::map<std::pair<State, bool>, std::pair<std::string, int>> counts;  // of each state, in Slurm's queue or not
  for (const PointStatus& s : points) {
    auto& [word, count] = counts[{s.point.state, s.is_queued}];
    word = s.state_word();
    ++count;
  }
  std::string text;
  for (const auto& [state, counted] : counts)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", counted.second, counted.first);
  return text;
}

Outlook outlook_of(const std::vector<PointStatus>& points) {
  Outlook outlook;
  double speed = 0, longest_s = 0, steps = 0;
  for (const PointStatus& s : points) {
    steps += static_cast<double>(s.steps_left());
    if (s.speed() <= 0) continue;
    ++outlook.living;
    speed += s.speed();
    longest_s = std::max(longest_s, static_cast<double>(s.steps_left()) / s.speed());
  }
  // Points that do not run yet are taken to go at the mean speed of those that do, as many at a time.
  if (outlook.living > 0) outlook.left_s = std::max(longest_s, steps / speed);
  return outlook;
}

bool is_in_trouble(const PointStatus& status) {
  const State state = status.point.state;
  return state == State::failed || state == State::refused || state == State::exhausted || state == State::crashed ||
         status.is_behind;
}

bool has_failures(const std::vector<PointStatus>& points) {
  return std::any_of(points.begin(), points.end(), [](const PointStatus& s) {
    return s.point.state == State::failed || s.point.state == State::refused || s.point.state == State::exhausted;
  });
}

}  // namespace rouleau::campaign
