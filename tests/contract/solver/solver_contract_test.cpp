// SPDX-License-Identifier: BSD-3-Clause
// The solver keeps share/contract.md: files, fields, checks, codes, fencing. Sections are those of that page.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <xxhash.h>

#include <array>
#include <sstream>

#include "restart/small_run.hpp"

namespace rouleau::testing {
namespace {

using nlohmann::json;

void expect_fields(const json& object, const std::vector<std::string>& names) {
  for (const auto& name : names) EXPECT_TRUE(object.contains(name)) << name << " is missing in " << object.dump();
}

/// Makes attempts/<k> with a token, as a manager does.
void make_attempt(const SmallRun& run, int k, const std::string& token) {
  std::filesystem::create_directories(run.path(fmt::format("attempts/{}", k)));
  set_content(run.path(fmt::format("attempts/{}/owner", k)), token + "\n");
}

TEST(Section2, CheckAnswersWithoutWritingAnything) {
  const SmallRun run;
  const Finished finished = run_program({ROULEAU_SOLVER, "check", run.path("run.ini").string(), "--format", "json"});
  ASSERT_EQ(finished.code, 0) << finished.err;
  const json answer = json::parse(finished.out);
  expect_fields(answer, {"contract", "version", "git", "parameters", "identity", "steps", "time_step_us", "nodes",
                         "triangles", "vertices", "cells", "end_time_s", "samples", "checkpoint_bytes",
                         "snapshot_bytes", "node_spacing_um", "relative_cost_per_step", "warnings"});
  EXPECT_EQ(answer.at("contract"), 1);
  EXPECT_EQ(answer.at("steps"), 40);
  EXPECT_EQ(answer.at("identity").get<std::string>().size(), 32u);
  for (const auto& parameter : answer.at("parameters"))
    expect_fields(parameter, {"name", "value", "default", "kind", "given"});
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(run.path("")), {}), 1) << "only run.ini";
}

TEST(Section2, IdentityDoesNotSeeSpellingOrDefaults) {
  const auto identity = [](const Changes& changes) {
    const SmallRun run(changes);
    const Finished finished = run_program({ROULEAU_SOLVER, "check", run.path("run.ini").string(), "--format", "json"});
    return json::parse(finished.out).at("identity").get<std::string>();
  };
  const std::string plain = identity({{"fluid.lambda", "4.75"}});
  EXPECT_EQ(plain, identity({{"fluid.lambda", "4.750"}}));
  EXPECT_EQ(plain, identity({{"fluid.lambda", "19/4"}, {"numerics.kernel", "4-point"}}));
  EXPECT_EQ(plain, identity({{"fluid.lambda", "4.75"}, {"output.sample_interval_steps", "20"}}));
  EXPECT_NE(plain, identity({{"fluid.lambda", "4.76"}}));
}

TEST(Section4, EverySampleLineCarriesItsCheck) {
  const SmallRun run;
  run.finish();
  std::istringstream lines(run.samples());
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line.rfind("step,time_s,cell,d_um,", 0), 0u);
  EXPECT_EQ(line.substr(line.rfind(',')), ",check");
  for (const char* column : {"x_um",
                             "y_um",
                             "z_um",
                             "asphericity",
                             "volume_ratio",
                             "area_ratio",
                             "inclination_deg",
                             "inside_nodes",
                             "inside_ratio",
                             "flips",
                             "mean_velocity_mm_per_s",
                             "pressure_gradient_Pa_per_m",
                             "velocity_x_mm_per_s",
                             "taylor_deformation",
                             "angle_xz_deg",
                             "angle_xy_deg",
                             "extent_x_um",
                             "extent_y_um",
                             "extent_z_um",
                             "marker_y_dx_um",
                             "marker_y_dy_um",
                             "marker_y_dz_um",
                             "marker_z_dx_um",
                             "marker_z_dy_um",
                             "marker_z_dz_um"})
    EXPECT_NE(line.find(std::string(",") + column + ","), std::string::npos) << column;
  int rows = 0;
  while (std::getline(lines, line)) {
    const auto comma = line.rfind(',');
    EXPECT_EQ(line.substr(comma + 1), fmt::format("{:016x}", XXH64(line.data(), comma, 0))) << line;
    ++rows;
  }
  EXPECT_EQ(rows, 5) << "steps 0, 10, 20, 30, 40";
}

TEST(Section4, RunWithoutACellHasALineASample) {
  const TemporaryDirectory place;
  set_content(place.path() / "run.ini",
              "[channel]\nlength_x_um = 4\nlength_y_um = 4\nlength_z_um = 4\n[cell]\nshape = none\n"
              "[flow]\nmean_velocity_mm_per_s = 0.5\n[numerics]\nnode_spacing_um = 0.5\ntime_step_us = 1\n"
              "[time]\nend_time_s = 1e-5\n[output]\nsample_interval_steps = 5\n");
  const Finished finished = run_program({ROULEAU_SOLVER, (place.path() / "run.ini").string()});
  ASSERT_EQ(finished.code, 0) << finished.err;
  std::istringstream lines(content_of(place.path() / "samples.csv"));
  std::string line;
  std::getline(lines, line);
  for (const std::string step : {"0,", "5,", "10,"}) {
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_TRUE(line.starts_with(step)) << line;
  }
  EXPECT_FALSE(std::getline(lines, line)) << line;
}

TEST(Sections5To7, RecordsHoldTheirFields) {
  const SmallRun run;
  run.finish();
  expect_fields(run.exit_record(),
                {"contract", "code", "reason", "step", "end_step", "start_step", "wall_s", "core_s", "ranks", "mlups",
                 "host", "resumed_from", "rejected_checkpoints", "version", "git", "finished_unix_s"});
  EXPECT_EQ(run.exit_record().at("code"), 0);
  const json started = json::parse(content_of(run.path("attempts/1/started.json")));
  expect_fields(started, {"contract", "host", "pid", "start_ticks", "boot_id", "ranks"});
  const json progress = json::parse(content_of(run.path("progress.json")));
  expect_fields(progress,
                {"contract", "attempt", "token", "step", "end_step", "time_s", "end_time_s", "steps_per_s", "mlups",
                 "checkpoint_step", "checkpoint_unix_s", "checkpoint_ms", "d_um", "asphericity", "updated_unix_s"});
  EXPECT_EQ(progress.at("step"), 40);
  EXPECT_TRUE(std::filesystem::exists(run.path("checkpoints/000000000040.h5")));
}

TEST(Section6, BadInputLeavesTheRecordOfAManagersAttempt) {
  SmallRun run;
  run.set("fluid.lambda", "minus two");
  make_attempt(run, 1, "t1");
  EXPECT_EQ(run.run(1, {"--attempt", "1", "--token", "t1"}).code, 65);
  EXPECT_EQ(run.exit_record().at("code"), 65);
}

TEST(Section6, WrongCommandLineIs64) {
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{},
                                             {"--nonsense"},
                                             {"run.ini", "more.ini"},
                                             {"run.ini", "--attempt", "2"},
                                             {"run.ini", "--ranks", "2x2"},
                                             {"run.ini", "--deadline-s", "-1"},
                                             {"check", "run.ini", "--format", "xml"},
                                             {"run.ini", "--attempt", "x"}}) {
    std::vector<std::string> command{ROULEAU_SOLVER};
    command.insert(command.end(), words.begin(), words.end());
    const Finished finished = run_program(command);
    EXPECT_EQ(finished.code, 64) << (words.empty() ? "" : words.back());
    EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
  }
}

TEST(Section6, ParallelErrorIsOneLineAndTheCodeOfAllRanks) {
  SmallRun run;
  run.set("numerics.time_step_us", "1000");
  const Finished finished = run.run(3);
  EXPECT_EQ(finished.code, 65);
  std::size_t count = 0;
  for (std::size_t at = finished.err.find("rouleau-solver:"); at != std::string::npos;
       at = finished.err.find("rouleau-solver:", at + 1))
    ++count;
  EXPECT_EQ(count, 1u) << finished.err;
}

TEST(Section6, UnwritableDirectoryIs74) {
  const SmallRun run;
  set_content(run.path("checkpoints"), "a file where the folder should be");
  const Finished finished = run.run();
  EXPECT_EQ(finished.code, 74) << finished.err;
}

TEST(Section6, FailedPhysicsIs70AndSaysWhenWhereAndWhatIsLeft) {
  const SmallRun undisturbed;
  undisturbed.finish();
  for (const auto& [bound, limit, relaxed, word] :
       {std::array{"bounds.area_ratio_min", "1", "0.7", "its area is"},
        std::array{"bounds.inside_ratio_max", "1", "1.3", "the flagged nodes fill"}}) {
    SmallRun run;
    run.set_steps(20);
    ASSERT_EQ(run.run().code, 0);
    run.set_steps(40);
    run.set(bound, limit);
    const Finished finished = run.run();
    EXPECT_EQ(finished.code, 70) << finished.err;
    const std::string reason = run.exit_record().at("reason");
    for (const std::string part : {"step 30: ", word, "Try ", "last good checkpoint: checkpoints/000000000020.h5"})
      EXPECT_NE(reason.find(part), std::string::npos) << part << " is not in: " << reason;
    EXPECT_FALSE(std::filesystem::exists(run.path("checkpoints/000000000040.h5")));
    // A bound is free: relaxed again, the run goes on as if it had never been there.
    run.set(bound, relaxed);
    ASSERT_EQ(run.run().code, 0);
    EXPECT_EQ(run.samples(), undisturbed.samples());
  }
}

TEST(Section6, RanksThatReadDifferentRunFilesEndAlikeWith74) {
  SmallRun run, changed;
  changed.set_steps(80);
  std::vector<std::string> words = launcher(2);
  words.back() = "1";  // rank 0 on one file, rank 1 on the other: as if it had been changed while they started
  words.insert(words.end(), {ROULEAU_SOLVER, run.path("run.ini").string(), "--quiet", ":", "-n", "1", ROULEAU_SOLVER,
                             changed.path("run.ini").string(), "--quiet"});
  // Far longer than such a run takes; ranks that differ would wait for ever.
  const Finished finished = run_program(words, Interruption{.after_s = 100});
  EXPECT_EQ(finished.code, 74) << finished.err;
  for (const char* part : {"rank 1 read time.end_time_s = ", ", rank 0 time.end_time_s = ", "Start the run again"})
    EXPECT_NE(finished.err.find(part), std::string::npos) << finished.err;
}

TEST(Section8, OlderAttemptStopsWith76AndWritesNothing) {
  SmallRun run;
  make_attempt(run, 1, "old");
  run.set_steps(20);
  EXPECT_EQ(run.run(1, {"--attempt", "1", "--token", "old"}).code, 0);
  const std::string samples = run.samples();
  make_attempt(run, 2, "new");
  run.set_steps(40);
  EXPECT_EQ(run.run(1, {"--attempt", "1", "--token", "old"}).code, 76);
  EXPECT_EQ(run.samples(), samples);
  EXPECT_EQ(run.run(1, {"--attempt", "2", "--token", "wrong"}).code, 76);
  EXPECT_EQ(run.run(1, {"--attempt", "2", "--token", "new"}).code, 0);
}

// Its exit.json would be taken for the end of the owner's process.
TEST(Section8, StartWithAnothersAttemptWritesNothingIntoItsFolder) {
  SmallRun run;
  make_attempt(run, 1, "owner's");
  const auto expect_nothing_written = [&](int attempt, int code, const std::string& word) {
    const Finished finished = run.run(1, {"--attempt", std::to_string(attempt), "--token", "wrong"});
    EXPECT_EQ(finished.code, code);
    EXPECT_NE(finished.err.find(word), std::string::npos) << finished.err;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(run.path("attempts")))
      EXPECT_TRUE(entry.is_directory() || entry.path().filename() == "owner") << entry.path() << " was written";
  };
  expect_nothing_written(1, 76, "attempt 1 belongs to another owner");
  std::filesystem::create_directory(run.path("attempts/2"));
  expect_nothing_written(2, 64, "no such attempt");
  std::filesystem::remove(run.path("attempts/2"));
  run.set("fluid.lambda", "minus two");
  expect_nothing_written(1, 65, "minus two is not a number");
}

TEST(Section10, CheckpointsThatAreOutOfReachEndTheRunAndTheSamplesStay) {
  const SmallRun undisturbed;
  undisturbed.finish();
  SmallRun run;
  run.set_steps(20);
  run.finish();
  run.set_steps(40);
  const std::string samples = run.samples();
  const auto folder = run.path("checkpoints"), volume = run.path("volume");
  std::filesystem::rename(folder, volume);
  const auto expect_refused = [&](const char* what) {
    const Finished finished = run.run();
    EXPECT_EQ(finished.code, 74) << what << finished.err;
    for (const char* word :
         {"holds no checkpoint, but ", "progress.json tells of one of step 20", "start the run again"})
      EXPECT_NE(finished.err.find(word), std::string::npos) << what << finished.err;
    EXPECT_EQ(run.samples(), samples) << what;
  };
  std::filesystem::create_symlink(run.path("not_mounted"), folder);
  expect_refused("a link to nowhere");
  std::filesystem::remove(folder);
  std::filesystem::create_directory(folder);
  expect_refused("an empty place to mount on");
  std::filesystem::remove(folder);
  expect_refused("nothing");
  // Back again, the run goes on as if it had never been away.
  std::filesystem::create_symlink(volume, folder);
  run.finish();
  EXPECT_EQ(run.samples(), undisturbed.samples());
}

TEST(Section10, RunWhoseCheckpointsAndSamplesWereMovedAwayStartsAnew) {
  SmallRun run;
  run.finish();
  const std::string samples = run.samples();
  std::filesystem::rename(run.path("checkpoints"), run.path("lost"));
  std::filesystem::rename(run.path("samples.csv"), run.path("old.csv"));
  run.finish();
  EXPECT_EQ(run.samples(), samples);
}

}  // namespace
}  // namespace rouleau::testing
