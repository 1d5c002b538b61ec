// SPDX-License-Identifier: BSD-3-Clause
// The fixed columns, the run parameters, and how names find them.
#include "report/columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "jobs/state.hpp"
#include "study/error.hpp"
#include "study/nearest.hpp"

namespace rouleau::campaign {
namespace {

using enum ColumnType;

const std::vector<Column>& fixed_columns() {
  static const std::vector<Column> columns = {
      {"ordinal", "p.ordinal", number, "number of the point: #3"},
      {"key", "p.key", text, "key of the point: its directory in points/"},
      {"state", "p.state", text, "waiting, running, stopped, done, failed, refused, crashed, exhausted or cancelled"},
      {"replica", "p.replica", number, "replica; 0 = none"},
      {"swept", "p.swept", text, "the swept parameters and their values"},
      {"in_study", "p.in_study", number, "1 while the study file names the point"},
      {"cell", "r.cell", number, "cell: 0, 1, ..."},
      {"class", "r.class", text, "croissant, slipper or undecided"},
      {"class_reason", "r.class_reason", text, "the numbers that decided the class"},
      {"note", "r.note", text, "what limits the figures"},
      {"d_mean_um", "r.d_mean_um", number, "mean displacement over the window, um", "d_error_um"},
      {"d_error_um", "r.d_error_um", number, "its standard error, um"},
      {"d_change_um", "r.d_change_um", number, "change of the mean from the window before, um"},
      {"d_amplitude_um", "r.d_amplitude_um", number, "amplitude of its oscillation, um"},
      {"d_period_s", "r.d_period_s", number, "period of its oscillation, s"},
      {"asphericity_mean", "r.asphericity_mean", number, "mean asphericity over the window", "asphericity_error"},
      {"asphericity_error", "r.asphericity_error", number, "its standard error"},
      {"tank_treading_per_s", "r.tank_treading_per_s", number, "turns of the membrane about the cell, 1/s",
       "tank_treading_error_per_s"},
      {"tank_treading_error_per_s", "r.tank_treading_error_per_s", number, "its standard error, 1/s"},
      {"tank_treading_reason", "r.tank_treading_reason", text, "over what it was taken, or why there is none"},
      {"time_s", "r.time_s", number, "time of the last sample, s"},
      {"step", "r.step", number, "step of the last sample"},
      {"window_s", "r.window_s", number, "the window asked for, s"},
      {"window_start_s", "r.window_start_s", number, "time of the first sample in the window, s"},
      {"samples", "r.samples", number, "samples in the window"},
      {"end_time_s", "p.end_time_s", number, "end time of the point, s"},
      {"end_step", "p.end_step", number, "step at the end time"},
      {"attempts", "p.attempts", number, "starts of the solver"},
      {"retries_used", "p.retries_used", number, "crashes in a row without progress"},
      {"wall_s", "p.wall_s", number, "wall time of all attempts that ended by themselves, s"},
      {"core_h", "p.core_h", number, "their core-hours"},
      {"mlups", "p.mlups", number, "million lattice updates a second, their mean over time"},
      {"host", "p.host", text, "host of the newest attempt"},
      {"version", "p.version", text, "version of the solver of the newest attempt"},
      {"git", "p.git", text, "git hash of that solver"},
  };
  return columns;
}

bool is_last_part(std::string_view full, std::string_view part) {
  return full.size() > part.size() && full.ends_with(part) && full[full.size() - part.size() - 1] == '.';
}

}  // namespace

std::string BoundValues::add(Value value) {
  values_.push_back(std::move(value));
  return fmt::format("?{}", values_.size());
}

Columns::Columns(const Store& store) : columns_(fixed_columns()) {
  // A parameter is a number if every point has a number for it.
  const Rows parameters = store.database().select(
      "SELECT name, min(value IS NOT NULL), max(swept) FROM parameter GROUP BY name ORDER BY min(position), name");
  for (const std::vector<Value>& row : parameters.rows) {
    const std::string& name = std::get<std::string>(row[0]);
    columns_.push_back({name, "", std::get<std::int64_t>(row[1]) != 0 ? number : text, "parameter of the run file"});
    if (std::get<std::int64_t>(row[2]) != 0) swept_.push_back(name);
  }
}

const Column& Columns::find(std::string_view name) const {
  for (const Column& column : columns_)
    if (column.name == name) return column;
  std::vector<const Column*> matches;
  for (const Column& column : columns_)
    if (is_last_part(column.name, name)) matches.push_back(&column);
  if (matches.size() == 1) return *matches.front();
  if (matches.size() > 1)
    fail(Exit::usage, "`{}` may mean {} or {}; write the whole name", name, matches[0]->name, matches[1]->name);
  std::vector<std::string> candidates;
  for (const Column& column : columns_) {
    candidates.push_back(column.name);
    if (const std::size_t dot = column.name.rfind('.'); dot != std::string::npos)
      candidates.push_back(column.name.substr(dot + 1));
  }
  fail(Exit::usage, "`{}` is no column.{} `rouleau query --list-columns` lists all", name,
       did_you_mean(name, candidates));
}

std::string Columns::short_name(const Column& column) const {
  const std::size_t dot = column.name.rfind('.');
  if (dot == std::string::npos) return column.name;
  const std::string last = column.name.substr(dot + 1);
  const auto has_last = [&](const Column& other) { return other.name == last || is_last_part(other.name, last); };
  return std::count_if(columns_.begin(), columns_.end(), has_last) == 1 ? last : column.name;
}

std::vector<std::string> words_of(const Column& column) {
  if (column.name == "state") return {state_words.begin(), state_words.end()};
  if (column.name == "class") return {"croissant", "slipper", "undecided"};
  return {};
}

std::string expression_of(const Column& column, BoundValues& values) {
  if (!column.sql.empty()) return column.sql;
  return fmt::format("(SELECT {} FROM parameter WHERE point = p.ordinal AND name = {})",
                     column.type == number ? "value" : "text", values.add(column.name));
}

}  // namespace rouleau::campaign
