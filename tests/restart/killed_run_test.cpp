// SPDX-License-Identifier: BSD-3-Clause
// Killed at random moments, signalled, timed out: the same command goes on, and the end is the same to the bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "restart/small_run.hpp"

namespace rouleau::testing {
namespace {

constexpr int steps = 9000;

/// Checkpoints as often as the loop looks at the clock.
const Changes many_checkpoints{{"output.checkpoint_interval_min", "0.001"}, {"output.progress_interval_s", "0.1"}};

TEST(KilledRun, RandomKillsOfAllRanksLeaveTheSameEnd) {
  SmallRun undisturbed(many_checkpoints), run(many_checkpoints);
  undisturbed.set_steps(steps);
  undisturbed.finish();
  run.set_steps(steps);
  // Each kill waits for a longer log than the one before, however fast the machine: all of them meet a living run. Some
  // come while it still starts, when the log is long enough already.
  const std::size_t whole = undisturbed.samples().size();
  std::mt19937 random(20);
  std::uniform_real_distribution<double> share(0, 0.12), delay(0, 0.05);
  double written = 0;
  for (int attempt = 0; attempt < 12; ++attempt) {
    written = std::min(0.9, written + share(random));
    const auto bytes = static_cast<std::uintmax_t>(written * static_cast<double>(whole));
    const Finished finished =
        run.run(1 + attempt % 3, {}, Interruption{delay(random), SIGKILL, run.path("samples.csv"), bytes});
    ASSERT_EQ(finished.signal, SIGKILL) << attempt << finished.err;
  }
  run.finish();
  EXPECT_EQ(run.fingerprint(), undisturbed.fingerprint());
}

TEST(KilledRun, SignalsStopBehindACheckpointWithCode75) {
  for (const int signal : {SIGUSR2, SIGTERM, SIGINT}) {
    SmallRun run;
    run.set_steps(1000000);
    const Finished finished = run.run(1, {}, Interruption{0.3, signal, run.path("progress.json")});
    EXPECT_EQ(finished.code, 75) << finished.err;
    const auto record = run.exit_record();
    EXPECT_EQ(record.at("code"), 75);
    EXPECT_GT(record.at("step"), 0);
    EXPECT_EQ(run.newest_checkpoint().at("metadata").at("step"), record.at("step"));
  }
}

TEST(KilledRun, SignalToMpirunReachesTheRanks) {
  SmallRun run;
  run.set_steps(1000000);
  const Finished finished = run.run(2, {}, Interruption{0.3, SIGUSR2, run.path("progress.json")});
  EXPECT_EQ(finished.code, 75) << finished.err;
  EXPECT_EQ(run.exit_record().at("reason"), "stop requested by signal");
}

TEST(KilledRun, DeadlineIsMetBehindACheckpoint) {
  SmallRun run;
  run.set_steps(1000000);
  const Finished finished = run.run(1, {"--deadline-s", "3"});
  EXPECT_EQ(finished.code, 75) << finished.err;
  EXPECT_EQ(run.exit_record().at("reason"), "deadline");
}

TEST(KilledRun, StopFileStops) {
  SmallRun run;
  run.set_steps(1000000);
  set_content(run.path("stop"), "");
  EXPECT_EQ(run.run().code, 75);
  std::filesystem::remove(run.path("stop"));
  run.set_steps(60);
  run.finish();
}

TEST(KilledRun, DamagedNewestCheckpointIsNamedAndTheOlderOneUsed) {
  SmallRun run;
  run.set_steps(60);
  run.finish();
  run.set_steps(120);
  run.finish();
  const auto newest = run.path("checkpoints/000000000120.h5");
  std::string bytes = content_of(newest);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
  set_content(newest, bytes);
  const Finished finished = run.run();
  EXPECT_EQ(finished.code, 0);
  EXPECT_NE(finished.err.find("000000000120.h5"), std::string::npos) << finished.err;
  EXPECT_EQ(run.exit_record().at("resumed_from"), "checkpoints/000000000060.h5");

  SmallRun whole;
  whole.set_steps(120);
  whole.finish();
  EXPECT_EQ(run.fingerprint(), whole.fingerprint());
}

TEST(KilledRun, NoSoundCheckpointIsNoReasonToStartAnewInSilence) {
  SmallRun run;
  run.finish();
  set_content(run.path("checkpoints/000000000040.h5"), "torn");
  const Finished finished = run.run();
  EXPECT_EQ(finished.code, 65);
  EXPECT_NE(finished.err.find("Move them"), std::string::npos) << finished.err;
}

}  // namespace
}  // namespace rouleau::testing
