// SPDX-License-Identifier: BSD-3-Clause
// The benchmark: all cases by turns, round after round, on two ranks of which one sleeps while the other measures
// alone.
#include <fmt/format.h>

#include <optional>

#include "base/error.hpp"
#include "coupled_cases.hpp"
#include "fluid_cases.hpp"
#include "loop_case.hpp"
#include "machine.hpp"
#include "plan.hpp"
#include "ray_times.hpp"
#include "result.hpp"
#include "size_sweep.hpp"
#include "storage/files.hpp"
#include "table.hpp"

namespace {

using namespace rouleau;
using namespace rouleau::speed;
using nlohmann::ordered_json;

/// Rank 0's cases at the paper's point that look at one simulation.
class PointCases {
 public:
  PointCases(const Plan& plan, const std::filesystem::path& directory, const Communicator& self)
      : plan_(plan),
        run_(paper_point(plan.studies / "study.ini", directory, plan.changes), self),
        loop_(run_, directory),
        fluid_(run_.setup().lattice.lattice, plan.enough_s, series_) {
    if (plan.wants("sweep")) sweep_.emplace(plan.edges, plan.enough_s / 10);
  }

  /// The fluid comes last, next to the coupled cases that it is compared with.
  void measure() {
    if (plan_.wants("coupled")) loop_.measure_shares(series_);
    if (plan_.wants("checkpoint")) loop_.measure_checkpoint(series_);
    if (sweep_) measure_growth();
    fluid_.measure(series_);
  }

  [[nodiscard]] PointFacts facts(const std::filesystem::path& directory) const {
    const Setup& setup = run_.setup();
    const auto steps = [&](const char* study) {
      return paper_point(plan_.studies / study, directory, {}).lattice.steps;
    };
    return {setup.lattice.lattice.nodes(), setup.cells.vertices(), setup.cells.triangles(), steps("study.ini"),
            steps("large-step.ini")};
  }
  [[nodiscard]] Series& series() { return series_; }

 private:
  void measure_growth() {
    const double enough_s = plan_.enough_s / 10;
    sweep_->measure(series_);
    const Cells& cells = run_.simulation().cells();
    const Lattice& lattice = run_.setup().lattice.lattice;
    series_.add("shell_raycast_ms_paper_point", 1e3 * shell_cast_seconds(cells, lattice, enough_s));
    series_.add("full_raycast_ms_paper_point", 1e3 * full_cast_seconds(cells, lattice, SizeSweep::measured_planes));
    series_.add("column_raycast_ms_paper_point", 1e3 * column_cast_seconds(cells, lattice, enough_s));
  }

  const Plan& plan_;
  Series series_;
  PointRun run_;
  LoopCase loop_;
  FluidCases fluid_;
  std::optional<SizeSweep> sweep_;
};

void report(PointCases& cases, const Plan& plan, const PointFacts& point, ordered_json load) {
  derive_figures(cases.series(), point);
  ordered_json json = result_json(cases.series(), point);
  json["machine"] = machine_facts();
  json["versions"] = version_facts();
  json["load"] = std::move(load);
  write_aside(posix_file_system(), plan.result, json.dump(2) + "\n");
  fmt::print("{}\n{}\n", result_table(cases.series(), point, json), plan.result.string());
}

void run(const Plan& plan, const Communicator& both) {
  const Pair pair(both);
  const Communicator self(MPI_COMM_SELF);
  const ForeignLoad load(both);
  const std::filesystem::path scratch = plan.result.string() + ".scratch";

  std::optional<PointCases> point;
  std::optional<CoupledCases> coupled;
  if (pair.is_first()) point.emplace(plan, scratch / "point", self);
  if (plan.wants("coupled"))
    coupled.emplace(CoupledPlan{plan.studies / "study.ini", scratch, plan.changes, plan.steps, plan.wants("ranks"),
                                plan.wants("jobs")},
                    pair, both, self);
  Series unused;  // rank 1 adds what it measures, too, and nobody reads it
  Series& series = point ? point->series() : unused;
  for (int round = 0; round < plan.rounds; ++round) {
    if (pair.is_first()) fmt::print(stderr, "\rround {} of {} ", round + 1, plan.rounds);
    pair.first_alone([&] { point->measure(); });
    if (coupled) coupled->measure(series);
  }
  if (pair.is_first()) fmt::print(stderr, "\n");
  if (coupled) coupled->check_health();
  ordered_json facts = load.facts();
  pair.first_alone([&] {
    report(*point, plan, point->facts(scratch / "facts"), std::move(facts));
    std::filesystem::remove_all(scratch);
  });
}

}  // namespace

int main(int argc, char** argv) {
  const MpiSession session(&argc, &argv);
  const Communicator both;
  // The other rank may wait for one that fails: MPI_Abort ends both.
  try {
    run(parse_plan(argc, argv), both);
    return 0;
  } catch (const rouleau::Error& error) {
    fmt::print(stderr, "benchmark: {}\n", error.what());
    MPI_Abort(both.raw(), static_cast<int>(error.code()));
  } catch (const std::exception& error) {
    fmt::print(stderr, "benchmark: {}\n", error.what());
    MPI_Abort(both.raw(), static_cast<int>(rouleau::Exit::internal));
  }
}
