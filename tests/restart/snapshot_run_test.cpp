// SPDX-License-Identifier: BSD-3-Clause
// Snapshots of a whole run: when, in which units, the same bytes whatever happened to the run, and without a trace in
// it.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numeric>
#include <set>
#include <sstream>

#include "restart/small_run.hpp"
#include "support/hdf5_array.hpp"

namespace rouleau::testing {
namespace {

/// Steps are of 1.25 us: fields every 10.4 steps, cells every 4.8.
const Changes with_snapshots{{"output.snapshot_interval_s", "1.3e-5"}, {"output.cell_snapshot_interval_s", "6e-6"}};

Changes with(Changes changes, const Changes& more) {
  for (const auto& [name, value] : more) changes[name] = value;
  return changes;
}

std::map<std::string, std::string> snapshots_of(const SmallRun& run) {
  std::map<std::string, std::string> all;
  if (!std::filesystem::exists(run.path("snapshots"))) return all;
  for (const auto& entry : std::filesystem::directory_iterator(run.path("snapshots")))
    all[entry.path().filename().string()] = content_of(entry.path());
  return all;
}

std::set<std::string> names_of(const std::map<std::string, std::string>& files) {
  std::set<std::string> names;
  for (const auto& [name, content] : files) names.insert(name);
  return names;
}

/// Values of one line of samples.csv by column.
std::map<std::string, double> sample_at(const SmallRun& run, const std::string& step) {
  std::istringstream lines(run.samples());
  std::string line, name, value;
  std::getline(lines, line);
  std::istringstream header(line);
  while (std::getline(lines, line) && !line.starts_with(step + ",")) {
  }
  std::istringstream row(line);
  std::map<std::string, double> values;
  while (std::getline(header, name, ',') && std::getline(row, value, ','))
    if (name != "check") values[name] = std::stod(value);
  return values;
}

TEST(SnapshotRun, StepsAreThoseNearestToTheTimesWanted) {
  const SmallRun run(with_snapshots);
  run.finish();
  std::set<std::string> expected{"fields.xdmf", "cells.xdmf"};
  for (const int step : {0, 10, 21, 31}) expected.insert(fmt::format("{:012}.h5", step));
  for (const int step : {0, 5, 10, 14, 19, 21, 24, 29, 31, 34, 38})
    expected.insert(fmt::format("cells-{:012}.h5", step));
  EXPECT_EQ(names_of(snapshots_of(run)), expected);
}

TEST(SnapshotRun, NothingIsWrittenByDefault) {
  const SmallRun run;
  run.finish();
  EXPECT_FALSE(std::filesystem::exists(run.path("snapshots")));
}

TEST(SnapshotRun, IsTheSameRunAsWithout) {
  for (const char* precision : {"single", "double"}) {
    const SmallRun with_them(with(with_snapshots, {{"numerics.precision", precision}}));
    const SmallRun without(Changes{{"numerics.precision", precision}});
    with_them.finish(2);
    without.finish();
    EXPECT_EQ(with_them.fingerprint(), without.fingerprint());
  }
}

TEST(SnapshotRun, BytesDoNotDependOnTheRanks) {
  const Changes thinned = with(with_snapshots, {{"output.snapshot_stride", "3"}});
  for (const Changes& changes : {with_snapshots, thinned}) {
    const SmallRun one(changes);
    one.finish(1);
    const auto expected = snapshots_of(one);
    for (const auto& [ranks, cut] : {std::pair{2, "1x2x1"}, {3, "1x1x3"}, {4, "2x1x2"}}) {
      const SmallRun other(changes);
      const Finished finished = other.run(ranks, {"--ranks", cut});
      ASSERT_EQ(finished.code, 0) << finished.err;
      EXPECT_TRUE(snapshots_of(other) == expected) << cut;
    }
  }
}

TEST(SnapshotRun, BytesDoNotDependOnStops) {
  const SmallRun whole(with_snapshots);
  whole.finish();
  SmallRun parts(with_snapshots);
  for (const int steps : {10, 11, 24, 40}) {
    parts.set_steps(steps);
    parts.finish(1 + steps % 3);
  }
  EXPECT_TRUE(snapshots_of(parts) == snapshots_of(whole));
  EXPECT_EQ(parts.fingerprint(), whole.fingerprint());
}

TEST(SnapshotRun, BytesDoNotDependOnKills) {
  const Changes often{{"output.snapshot_interval_s", "2e-4"},
                      {"output.cell_snapshot_interval_s", "5e-5"},
                      {"output.checkpoint_interval_min", "0.002"}};
  constexpr int steps = 1600;
  SmallRun undisturbed(often), run(often);
  undisturbed.set_steps(steps);
  undisturbed.finish();
  run.set_steps(steps);
  const std::size_t whole = undisturbed.samples().size();
  for (const double share : {0.2, 0.5, 0.8}) {
    const auto bytes = static_cast<std::uintmax_t>(share * static_cast<double>(whole));
    const Finished finished = run.run(1, {}, Interruption{0, SIGKILL, run.path("samples.csv"), bytes});
    ASSERT_EQ(finished.signal, SIGKILL) << finished.err;
  }
  run.finish();
  EXPECT_EQ(names_of(snapshots_of(run)), names_of(snapshots_of(undisturbed)));
  EXPECT_TRUE(snapshots_of(run) == snapshots_of(undisturbed));
}

TEST(SnapshotRun, ParametersMayChangeBetweenAttempts) {
  SmallRun run(with_snapshots);
  run.set_steps(20);
  run.finish();
  run.set("output.snapshot_interval_s", "2.5e-5");  // 20 steps
  run.set("output.cell_snapshot_interval_s", "0");
  run.set("output.snapshot_stride", "2");
  run.set_steps(40);
  run.finish();
  const auto files = snapshots_of(run);
  for (const int step : {0, 10, 20, 40}) EXPECT_TRUE(files.contains(fmt::format("{:012}.h5", step))) << step;
  EXPECT_THAT(files.at("fields.xdmf"), ::testing::HasSubstr("Dimensions=\"15 18 24\""));
  EXPECT_THAT(files.at("fields.xdmf"), ::testing::HasSubstr("Dimensions=\"8 9 12\""));
  SmallRun plain;
  plain.finish();
  EXPECT_EQ(run.fingerprint(), plain.fingerprint());
}

TEST(SnapshotRun, ThinnedFieldsAreEveryNthNode) {
  const Changes changes{{"output.snapshot_interval_s", "2.5e-5"}};
  const SmallRun all(changes), some(with(changes, {{"output.snapshot_stride", "4"}}));
  all.finish();
  some.finish(2);
  for (const char* name : {"velocity_mm_per_s", "membrane_force_pN_per_um3"}) {
    const auto whole = hdf5_array<double>(all.path("snapshots/000000000020.h5"), name);
    const auto thin = hdf5_array<double>(some.path("snapshots/000000000020.h5"), name);
    ASSERT_EQ(thin.shape, (std::vector<hsize_t>{4, 5, 6, 3}));
    std::size_t next = 0;
    for (std::size_t k = 0; k < 15; k += 4)
      for (std::size_t j = 0; j < 18; j += 4)
        for (std::size_t i = 0; i < 24; i += 4)
          for (std::size_t a = 0; a < 3; ++a)
            ASSERT_EQ(thin.values[next++], whole.values[((k * 18 + j) * 24 + i) * 3 + a]) << name;
  }
}

/// At step 40, which is sampled too.
TEST(SnapshotRun, ShowsWhatTheSamplesSay) {
  const SmallRun run(Changes{{"output.snapshot_interval_s", "5e-5"}});
  run.finish();
  auto sample = sample_at(run, "40");
  const auto fields = run.path("snapshots/000000000040.h5"), cells = run.path("snapshots/cells-000000000040.h5");

  const auto velocity = hdf5_array<double>(fields, "velocity_mm_per_s").values;
  double mean = 0, largest = 0;
  for (std::size_t node = 0; node < velocity.size(); node += 3) {
    mean += velocity[node] / (static_cast<double>(velocity.size()) / 3);
    largest = std::max(largest, velocity[node]);
  }
  // The sample's momentum is that before streaming, and over the mean density.
  EXPECT_NEAR(mean, sample.at("mean_velocity_mm_per_s"), 2e-3 * mean);
  EXPECT_GT(largest, 1.5 * mean);
  EXPECT_LT(largest, 2.3 * mean);

  const auto inside = hdf5_array<int>(fields, "inside").values;
  EXPECT_EQ(std::accumulate(inside.begin(), inside.end(), 0), sample.at("inside_nodes"));

  const auto X = hdf5_array<double>(cells, "vertices_um").values;
  const char* const extents[] = {"extent_x_um", "extent_y_um", "extent_z_um"};
  for (std::size_t a = 0; a < 3; ++a) {
    double lower = 1e9, upper = -1e9;
    for (std::size_t v = a; v < X.size(); v += 3) {
      lower = std::min(lower, X[v]);
      upper = std::max(upper, X[v]);
    }
    EXPECT_NEAR(upper - lower, sample.at(extents[a]), 1e-5);  // single precision
  }

  // Spread on the lattice, the force of the membrane is what it was; all of it is as good as nothing, like each part of
  // it.
  const auto force = hdf5_array<double>(cells, "force_pN").values;
  const auto density = hdf5_array<double>(fields, "membrane_force_pN_per_um3").values;
  // And so is its first moment, which the 4-point kernel keeps: both have the same units.
  const double dx = 2.0 / 3, node_um3 = dx * dx * dx;
  for (std::size_t a = 1; a < 3; ++a) {  // not along x, where the seam cuts
    double on_vertices = 0, on_nodes = 0, size = 0, moment_of_vertices = 0, moment_of_nodes = 0;
    for (std::size_t v = a; v < force.size(); v += 3) {
      on_vertices += force[v];
      size += std::abs(force[v]);
      moment_of_vertices += X[v] * force[v];
    }
    for (std::size_t n = 0; n < density.size() / 3; ++n) {
      const std::size_t along_axis = a == 1 ? n / 24 % 18 : n / (24 * 18);
      on_nodes += density[3 * n + a] * node_um3;
      moment_of_nodes += dx * (0.5 + static_cast<double>(along_axis)) * density[3 * n + a] * node_um3;
    }
    EXPECT_GT(size, 1) << "pN";
    EXPECT_NEAR(on_vertices, 0, 1e-5 * size);  // single precision
    EXPECT_NEAR(on_nodes, 0, 1e-5 * size);
    EXPECT_GT(std::abs(moment_of_vertices), 0.01 * size);
    EXPECT_NEAR(moment_of_nodes, moment_of_vertices, 1e-4 * size);
  }

  // C kappa_S resists areas with 250 uN/m: strains and tensions are small, and go together.
  const auto strain = hdf5_array<double>(cells, "area_strain").values;
  const auto tension = hdf5_array<double>(cells, "tension_uN_per_m").values;
  double product = 0, strains = 0, tensions = 0;
  for (std::size_t v = 0; v < strain.size(); ++v) {
    product += strain[v] * tension[v];
    strains += strain[v] * strain[v];
    tensions += tension[v] * tension[v];
  }
  EXPECT_GT(product, 0.9 * std::sqrt(strains * tensions));
  EXPECT_NEAR(std::sqrt(tensions / strains), 5.0 * 100 / 6 * 4, 60);  // dT/ds of Skalak's law: 2/3 kappa_A for s -> 0
}

TEST(SnapshotRun, CellAcrossTheSeamIsWhole) {
  const SmallRun run(Changes{{"output.cell_snapshot_interval_s", "2e-5"}});
  run.finish();
  const auto X = hdf5_array<double>(run.path("snapshots/cells-000000000000.h5"), "vertices_um").values;
  const auto T = hdf5_array<int>(run.path("snapshots/cells-000000000000.h5"), "triangles").values;
  double last = 0;
  for (std::size_t v = 0; v < X.size(); v += 3) last = std::max(last, X[v]);
  EXPECT_GT(last, 16.5) << "um; the box ends at 16";
  for (std::size_t t = 0; t < T.size(); t += 3)
    for (std::size_t e = 0; e < 3; ++e) {
      const auto a = 3 * static_cast<std::size_t>(T[t + e]), b = 3 * static_cast<std::size_t>(T[t + (e + 1) % 3]);
      const double edge = std::hypot(X[a] - X[b], X[a + 1] - X[b + 1], X[a + 2] - X[b + 2]);
      EXPECT_LT(edge, 2) << "um";
    }
}

TEST(SnapshotRun, RunWithoutACellHasFieldsAlone) {
  const TemporaryDirectory place;
  set_content(place.path() / "run.ini",
              "[channel]\nlength_x_um = 4\nlength_y_um = 4\nlength_z_um = 4\n[cell]\nshape = none\n"
              "[flow]\nmean_velocity_mm_per_s = 0.5\n[numerics]\nnode_spacing_um = 0.5\ntime_step_us = 1\n"
              "[time]\nend_time_s = 1e-5\n[output]\nsnapshot_interval_s = 1e-5\n");
  const Finished finished = run_program({ROULEAU_SOLVER, (place.path() / "run.ini").string(), "--quiet"});
  ASSERT_EQ(finished.code, 0) << finished.err;
  EXPECT_TRUE(std::filesystem::exists(place.path() / "snapshots/000000000010.h5"));
  EXPECT_FALSE(std::filesystem::exists(place.path() / "snapshots/cells.xdmf"));
}

TEST(SnapshotRun, CheckSaysWhatTheyWillTake) {
  const SmallRun run(with(with_snapshots, {{"output.snapshot_interval_s", "1.25e-5"}}));
  run.finish(2);
  double bytes = 0;
  for (const auto& [name, content] : snapshots_of(run)) bytes += static_cast<double>(content.size());
  const Finished check = run_program({ROULEAU_SOLVER, "check", run.path("run.ini").string(), "--format", "json"});
  const auto said = nlohmann::json::parse(check.out).at("snapshot_bytes").get<double>();
  EXPECT_GT(said, bytes) << "an estimate from above";
  EXPECT_LT(said, 1.6 * bytes) << "the one at rest takes less";
  const SmallRun none;
  const Finished other = run_program({ROULEAU_SOLVER, "check", none.path("run.ini").string(), "--format", "json"});
  EXPECT_EQ(nlohmann::json::parse(other.out).at("snapshot_bytes"), 0);
}

TEST(SnapshotRun, ImpossibleWishesAreRefusedByName) {
  for (const auto& [name, value] : {std::pair{"output.snapshot_interval_s", "1e-6"},
                                    {"output.cell_snapshot_interval_s", "1e-6"},
                                    {"output.snapshot_stride", "15"}}) {
    const SmallRun run(with(with_snapshots, {{name, value}}));
    const Finished finished = run.run();
    EXPECT_EQ(finished.code, 65);
    EXPECT_THAT(finished.err, ::testing::HasSubstr(name));
  }
}

}  // namespace
}  // namespace rouleau::testing
