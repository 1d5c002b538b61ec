// SPDX-License-Identifier: BSD-3-Clause
#include "coupled_cases.hpp"

#include <array>

#include "stopwatch.hpp"

namespace rouleau::speed {

namespace {

constexpr auto parts = static_cast<std::size_t>(Part::count);

std::array<double, parts> seconds_of_parts(const StepTimers& timers) {
  std::array<double, parts> seconds{};
  for (std::size_t p = 0; p < parts; ++p) seconds[p] = timers.seconds(static_cast<Part>(p));
  return seconds;
}

}  // namespace

CoupledCases::CoupledCases(CoupledPlan plan, const Pair& pair, const Communicator& both, const Communicator& self)
    : plan_(std::move(plan)), pair_(pair), both_(both) {
  for (const std::string precision : {"single", "double"})
    for (const std::string kernel : {"2", "4"}) {
      if (!pair.is_first()) continue;
      const Changes changes{{"numerics.kernel", kernel + "-point"}, {"numerics.precision", precision}};
      alone_.push_back(make_case(kernel + "pt_" + precision, changes, self));
    }
  for (const std::string kernel : {"2", "4"})
    if (plan_.two_ranks)
      together_.push_back(make_case(kernel + "pt_single", {{"numerics.kernel", kernel + "-point"}}, both));
  if (plan_.two_jobs) job_.emplace(make_case("4pt_single", {}, self));
}

CoupledCases::Case CoupledCases::make_case(const std::string& name, const Changes& changes,
                                           const Communicator& comm) const {
  Changes all = plan_.changes;
  all["bounds.unsafe_combination"] = "run";  // for some hundred steps any kernel will do
  for (const auto& [key, value] : changes) all[key] = value;
  const auto directory = plan_.scratch / ("rank-" + std::to_string(both_.rank())) / name;
  return {name, PointRun(paper_point(plan_.study, directory, all), comm)};
}

double CoupledCases::batch_seconds(Case& timed, Series& series) const {
  const int warm_up = plan_.steps / 8;  // other cases have filled the caches since
  timed.run.step(warm_up);
  const StepTimers& timers = timed.run.simulation().timers();
  const auto before = seconds_of_parts(timers);
  const double seconds = seconds_of([&] { timed.run.step(plan_.steps); });
  const auto after = seconds_of_parts(timers);
  const std::string group = (timed.run.comm().size() == 2 ? "parts_two_ranks." : "parts.") + timed.name + ".";
  for (std::size_t p = 0; p < parts; ++p) series.add(group + part_names[p], 1e3 * (after[p] - before[p]) / plan_.steps);
  return seconds;
}

void CoupledCases::measure(Series& series) {
  pair_.first_alone([&] {
    for (Case& c : alone_) series.add("coupled_ms_" + c.name, 1e3 * batch_seconds(c, series) / plan_.steps);
  });
  for (Case& c : together_) {
    pair_.start_together();
    const double seconds = both_.max(batch_seconds(c, series));
    series.add("two_rank_ms_" + c.name, 1e3 * seconds / plan_.steps);
  }
  if (job_) measure_two_jobs(series);
}

void CoupledCases::measure_two_jobs(Series& series) {
  job_->run.step(plan_.steps / 8);
  pair_.start_together();
  const double seconds = seconds_of([&] { job_->run.step(plan_.steps); });
  const auto microseconds = static_cast<std::int64_t>(1e6 * seconds);
  const double shortest = 1e-6 * static_cast<double>(both_.min(microseconds));
  const double longest = 1e-6 * static_cast<double>(both_.max(microseconds));
  series.add("two_jobs_steps_per_s", plan_.steps / shortest + plan_.steps / longest);
}

void CoupledCases::check_health() {
  for (Case& c : alone_) c.run.simulation().check_health();
  for (Case& c : together_) c.run.simulation().check_health();
  if (job_) job_->run.simulation().check_health();
}

}  // namespace rouleau::speed
