// SPDX-License-Identifier: BSD-3-Clause
// `rouleau plan`: what there is to do and what it will cost.
#include <algorithm>
#include <memory>
#include <ostream>

#include "commands/calibrate.hpp"
#include "commands/planned_point.hpp"
#include "commands/print.hpp"
#include "commands/verbs.hpp"
#include "executor/cores.hpp"
#include "executor/solver.hpp"
#include "ingest/run_files.hpp"
#include "jobs/estimate.hpp"
#include "store/store.hpp"
#include "study/expand.hpp"
#include "study/merge.hpp"
#include "study/numbers.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

namespace po = boost::program_options;

constexpr double default_seconds = 8;

void describe(po::options_description& options) {
  auto add = options.add_options();
  add("no-calibrate", po::bool_switch(), "do not run the solver to measure its speed");
  add("calibrate-s", po::value<double>()->value_name("S")->default_value(default_seconds), "seconds to measure for");
}

/// A point as planned, whether or not it is in a campaign already.
struct Item {
  Point point;
  State state = State::waiting;
  std::int64_t steps_done = 0;
  std::filesystem::path run;  ///< its directory; empty: there is none yet
};

/// What is planned: of a campaign, or of a study file.
struct Plan {
  Study study;
  std::vector<Item> items;
  std::filesystem::path place;                ///< whose disk counts
  std::filesystem::path files;                ///< where named files lie
  std::string run_file;                       ///< of the first item that has steps left
  std::optional<double> cost;                 ///< core-seconds per relative cost, from what was run
  std::string source;                         ///< where `cost` is from
  std::unique_ptr<ScratchDirectory> scratch;  ///< holds the named files of a study that is no campaign yet
};

Plan plan_of_study(const std::filesystem::path& file) {
  Plan plan;
  plan.study = read_study(file);
  const Expansion expansion = expand(plan.study, solver_checker(find_solver()));
  for (const Candidate& candidate : merge({}, expansion).added)
    plan.items.push_back({candidate.point, State::waiting, 0, {}});
  plan.place = std::filesystem::absolute(file).parent_path();
  plan.scratch = std::make_unique<ScratchDirectory>();
  plan.files = plan.scratch->path() / "files";
  std::filesystem::create_directory(plan.files);
  for (const auto& [text, named] : expansion.files) {
    std::filesystem::create_symlink(named.source, plan.scratch->path() / named.stored);
  }
  if (!expansion.candidates.empty()) plan.run_file = expansion.candidates.front().run_file;
  return plan;
}

/// Speed of what has run so far: the newest attempts with a figure, all points weighing alike.
void measure_from_attempts(Plan& plan, const Store& store) {
  double sum = 0;
  int count = 0;
  for (const Item& item : plan.items) {
    const std::vector<AttemptRow> attempts = store.attempts(item.point.key);
    const auto newest = std::find_if(attempts.rbegin(), attempts.rend(),
                                     [](const AttemptRow& a) { return a.mlups.value_or(0) > 0 && a.ranks > 0; });
    if (newest == attempts.rend()) continue;
    const RunFacts& facts = item.point.facts;
    sum += core_seconds_per_cost(*newest->mlups, newest->ranks, facts.nodes, facts.relative_cost_per_step);
    ++count;
  }
  if (count == 0) return;
  plan.cost = sum / count;
  plan.source = fmt::format("speed as measured by {} points that ran", count);
}

std::int64_t steps_done(const std::filesystem::path& run, State state, std::int64_t end_step) {
  if (state == State::done) return end_step;
  const std::vector<std::int64_t> checkpoints = checkpoint_steps(run);
  return checkpoints.empty() ? 0 : std::min(checkpoints.back(), end_step);
}

Plan plan_of_campaign(const std::filesystem::path& directory) {
  Plan plan;
  const Store store = Store::open_reader(directory / "campaign.db");
  plan.study = parse_study(store.campaign().study_text, directory / "study.ini");
  plan.place = directory;
  plan.files = directory / "files";
  for (const PointRow& row : store.points()) {
    if (!row.in_study) continue;
    const std::filesystem::path run = point_directory(directory, row.key);
    Item item{read_point(run / "point.json"), row.state, steps_done(run, row.state, row.end_step), run};
    if (plan.run_file.empty() && !is_final(row.state)) plan.run_file = read_whole_file(run / "run.ini").value_or("");
    plan.items.push_back(std::move(item));
  }
  measure_from_attempts(plan, store);
  return plan;
}

PlannedPoint planned(const Item& item) { return planned_point(item.point, item.state, item.steps_done); }

int jobs_of(const Plan& plan) {
  const Execution& execution = plan.study.execution;
  return jobs_at_a_time(static_cast<int>(execution.jobs), static_cast<int>(execution.ranks),
                        static_cast<int>(allowed_cores().size()), execution.oversubscribe != 0);
}

void calibrate_if_needed(const CommandLine& line, Plan& plan) {
  const auto points_left = std::count_if(plan.items.begin(), plan.items.end(),
                                         [](const Item& item) { return planned(item).steps_left > 0; });
  if (plan.cost || line.is_set("no-calibrate") || points_left == 0 || plan.run_file.empty()) return;
  const auto first =
      std::find_if(plan.items.begin(), plan.items.end(), [](const Item& i) { return !is_final(i.state); });
  const double seconds = line.get<double>("calibrate-s");
  const int ranks = static_cast<int>(plan.study.execution.ranks);
  if (!line.quiet) line.io.err << fmt::format("measuring the solver's speed for {:.3g} s ...", seconds) << std::endl;
  const int jobs = static_cast<int>(std::min<std::ptrdiff_t>(jobs_of(plan), points_left));
  const Calibration measured = calibrate(plan.run_file, plan.files, seconds, ranks, jobs);
  if (!measured.trouble.empty()) {
    line.io.err << "no speed could be measured: " << measured.trouble << std::endl;
    return;
  }
  const RunFacts& facts = first->point.facts;
  plan.cost = core_seconds_per_cost(measured.mlups, ranks, facts.nodes, facts.relative_cost_per_step);
  plan.source = fmt::format("speed measured on {}, {} side by side: {:.3g} MLUPS each on {} ranks",
                            first->point.label(), jobs, measured.mlups, ranks);
}

struct Totals {
  std::int64_t steps = 0, steps_left = 0;
  double core_hours = 0, disk_MiB = 0, missing_MiB = 0;
  std::vector<double> hours;  ///< of each point
};

Value known(const Plan& plan, double value) { return plan.cost ? Value(value) : Value(std::monostate{}); }

/// One row a point, and the total.
Table table_of(const Plan& plan, Totals& totals) {
  const int ranks = static_cast<int>(plan.study.execution.ranks);
  Table table{"plan", {"point", "parameters", "state", "steps", "steps_left", "core_hours", "hours", "disk_MiB"}, {}};
  for (const Item& item : plan.items) {
    PlannedPoint point = planned(item);
    const double cost = core_hours(point, plan.cost.value_or(0));
    const std::int64_t steps = item.point.facts.steps;
    PlannedPoint whole = point;
    whole.steps_left = steps;
    point.hours = core_hours(whole, plan.cost.value_or(0)) / ranks;
    table.rows.push_back({fmt::format("#{}", item.point.ordinal), item.point.label(), std::string(word_of(item.state)),
                          steps, point.steps_left, known(plan, cost), known(plan, cost / ranks), disk_MiB(point)});
    totals.steps += steps;
    totals.steps_left += point.steps_left;
    totals.core_hours += cost;
    totals.disk_MiB += disk_MiB(point);
    totals.missing_MiB += missing_MiB(point, item.state, item.run);
    totals.hours.push_back(cost / ranks);
  }
  const int jobs = jobs_of(plan);
  table.rows.push_back({"total", fmt::format("{} points, {} jobs of {} ranks", plan.items.size(), jobs, ranks),
                        std::monostate{}, totals.steps, totals.steps_left, known(plan, totals.core_hours),
                        known(plan, hours_in_all(totals.hours, jobs)), totals.disk_MiB});
  return table;
}

int plan(const CommandLine& line) {
  Plan plan = std::filesystem::is_regular_file(line.directory) ? plan_of_study(line.directory)
                                                               : plan_of_campaign(line.directory);
  calibrate_if_needed(line, plan);
  Totals totals;
  print(line, table_of(plan, totals));
  if (line.quiet) return static_cast<int>(Exit::ok);
  const double free = static_cast<double>(std::filesystem::space(plan.place).available) / (1024.0 * 1024.0);
  if (!plan.source.empty()) line.io.err << plan.source << "\n";
  line.io.err << fmt::format(
      "disk: {:.0f} MiB in all at the end, {:.0f} MiB of them to come, {:.0f} MiB free at {}{}\n", totals.disk_MiB,
      totals.missing_MiB, free, plan.place.string(), totals.missing_MiB > free ? ": NOT ENOUGH" : "");
  return static_cast<int>(Exit::ok);
}

}  // namespace

const Verb plan_verb = {
    "plan",
    "points, steps, core-hours, wall-clock and disk; starts nothing",
    "[DIR | STUDY] [--no-calibrate | --calibrate-s S] [--format csv|json]",
    "  rouleau plan my-campaign             what is left to do\n"
    "  rouleau plan study.ini               the same before there is a campaign\n"
    "  rouleau plan study.ini --format csv  for a spreadsheet\n",
    "The speed is that of the points that ran already; if none did, the solver is run for some seconds on a copy of\n"
    "the first point. `hours` of the total row counts the jobs that run at a time.\n",
    Words::campaign,
    true,
    describe,
    plan,
};

}  // namespace rouleau::campaign
