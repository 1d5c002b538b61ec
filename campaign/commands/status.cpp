// SPDX-License-Identifier: BSD-3-Clause
// `rouleau status`: a line a point, from the database and from what the run directories say at this moment.
#include <algorithm>
#include <ostream>

#include "commands/duration.hpp"
#include "commands/pause.hpp"
#include "commands/point_status.hpp"
#include "commands/print.hpp"
#include "commands/verbs.hpp"
#include "commands/watch.hpp"
#include "report/columns.hpp"
#include "study/numbers.hpp"

namespace rouleau::campaign {

namespace {

namespace po = boost::program_options;

constexpr double shortest_interval_s = 0.1, longest_interval_s = 86400;

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
                                   s.fraction(),
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
  const std::vector<Value> rest = {s.state_word(),
                                   fmt::format("{:.0f} %", std::min(100.0, 100 * s.fraction())),
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
                                                "checkpoint", "d_um", "attempts", "note"};

/// "quick: 7 points: 3 done, 2 running, 2 waiting; about 2 h 10 min left with 2 running"
std::string summary(const CampaignRow& campaign, const std::vector<PointStatus>& all) {
  const std::string text =
      fmt::format("{}: {} point{}: {}", campaign.name, all.size(), all.size() == 1 ? "" : "s", states_text(all));
  const Outlook outlook = outlook_of(all);
  if (outlook.living == 0) return text;
  return text + fmt::format("; about {} left with {} running", duration_text(outlook.left_s), outlook.living);
}

void describe(po::options_description& options) {
  auto add = options.add_options();
  add("watch", po::value<std::string>()->implicit_value("")->value_name("SECONDS"),
      "one screen, drawn anew so often (2) until all points are through or Ctrl-C; lines (60) when stdout is no "
      "terminal");
  add("exit-code", po::bool_switch(), "end with 4 if points failed, were refused or are exhausted");
}

/// What --watch asks for, if it was given: seconds, or nothing for the usual ones.
std::optional<double> watch_interval(const CommandLine& line) {
  const auto& text = line.get<std::string>("watch");
  if (line.format != Format::table)
    fail(Exit::usage, "rouleau status: --watch is for eyes; --format csv and json go without it");
  if (text.empty()) return std::nullopt;
  const std::optional<double> seconds = parse_number(text);
  if (!seconds || !(*seconds >= shortest_interval_s) || *seconds > longest_interval_s)
    fail(Exit::usage, "rouleau status: --watch={}: seconds from {} to {} are needed, or none", text,
         shortest_interval_s, longest_interval_s);
  return seconds;
}

/// Prints the listing.   returns the points
std::vector<PointStatus> list(const CommandLine& line) {
  const Store store = Store::open_reader(line.directory / "campaign.db");
  const double now = now_unix_s();
  const Columns columns(store);
  std::vector<PointStatus> all = StatusReader(line.directory).read(store, columns.swept());

  const bool for_eyes = line.format == Format::table;
  Table table{"status", {for_eyes ? "point" : "ordinal"}, {}};
  if (!for_eyes) table.columns.push_back("key");
  for (const std::string& name : columns.swept()) table.columns.push_back(columns.short_name(columns.find(name)));
  const std::vector<std::string>& rest = for_eyes ? short_columns : exact_columns;
  table.columns.insert(table.columns.end(), rest.begin(), rest.end());
  for (const PointStatus& s : all) table.rows.push_back(for_eyes ? short_row(s, now) : exact_row(s, now));
  const std::size_t done = 2 + columns.swept().size();  // behind point, axes and state; then MLUPS, left, ...
  if (for_eyes) table.right_aligned = {0, done, done + 1, done + 2, done + 3, done + 4};
  print(line, table);
  const CampaignRow campaign = store.campaign();
  if (!line.quiet) line.io.err << summary(campaign, all) << '\n';
  const Breaker breaker = kept_breaker(store, parse_study(campaign.study_text, line.directory / "study.ini"));
  if (breaker.has_tripped()) line.io.err << pause_text(breaker) << '\n';
  return all;
}

int status(const CommandLine& line) {
  const std::vector<PointStatus> all = line.has("watch") ? watch(line, watch_interval(line)) : list(line);
  return static_cast<int>(line.is_set("exit-code") && has_failures(all) ? Exit::some_failed : Exit::ok);
}

}  // namespace

const Verb status_verb = {
    "status",
    "how far each point is",
    "[DIR] [--watch[=SECONDS]] [--format csv|json] [--exit-code]",
    "  rouleau status my-campaign                 a line a point, a summary on stderr\n"
    "  rouleau status my-campaign --watch         one screen, drawn anew every two seconds; Ctrl-C leaves\n"
    "  rouleau status my-campaign --watch > log   changes of state, and a line a minute\n"
    "  rouleau status my-campaign --format json   for programs\n",
    "Reads only, and works while `rouleau run` runs. `left` and `MLUPS` are those of running jobs; `d_um` is the last\n"
    "displacement. States: waiting, queued (by Slurm), running, stopped (will be continued), done,\n"
    "failed (physics), refused (bad input), crashed (will be retried), exhausted (retries used up), cancelled.\n",
    Words::campaign,
    true,
    describe,
    status,
};

}  // namespace rouleau::campaign
