// SPDX-License-Identifier: BSD-3-Clause
// A real small disk that fills up under solver and manager: a clear message, exit code 74, no damage; with room again
// the same command goes on.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/mount.h>

#include "crash/faults/busy_run.hpp"
#include "crash/faults/busy_study.hpp"
#include "crash/faults/plan.hpp"
#include "support/campaign_outcome.hpp"

namespace rouleau::testing {
namespace {

constexpr std::uintmax_t disk_bytes = 32 << 20;

/// A small disk on a directory, as long as it lives.
class SmallDisk {
 public:
  explicit SmallDisk(std::filesystem::path directory) : directory_(std::move(directory)) {
    std::filesystem::create_directories(directory_);
    const std::string size = fmt::format("size={}", disk_bytes);
    is_mounted_ = ::mount("tmpfs", directory_.c_str(), "tmpfs", 0, size.c_str()) == 0;
  }
  ~SmallDisk() {
    if (is_mounted_) ::umount2(directory_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  [[nodiscard]] bool is_mounted() const { return is_mounted_; }
  /// Fills it up to so many free bytes.
  void leave(std::uintmax_t bytes) const {
    const std::uintmax_t room = std::filesystem::space(directory_).available;
    set_content(ballast(), std::string(room - bytes, 'x'));
  }
  void make_room() const { std::filesystem::remove(ballast()); }

 private:
  [[nodiscard]] std::filesystem::path ballast() const { return directory_ / "ballast"; }

  std::filesystem::path directory_;
  bool is_mounted_;
};

constexpr const char* no_mount = "mounting a small tmpfs needs root";

/// Runs a run on a small disk to step 96, with a checkpoint at step 48 or none, where it finds room for so many
/// checkpoints; then with room.
void expect_74_and_no_damage(int ranks, bool has_checkpoint, const std::vector<double>& checkpoints_of_room) {
  BusyRun undisturbed;
  undisturbed.set_steps(96);
  undisturbed.finish(ranks);
  const auto bytes = static_cast<double>(std::filesystem::file_size(undisturbed.path("checkpoints/000000000096.h5")));
  for (const double room : checkpoints_of_room) {
    SCOPED_TRACE(fmt::format("room for {} checkpoints of {} bytes, {} ranks", room, bytes, ranks));
    BusyRun run;
    const SmallDisk disk(run.directory());
    if (!disk.is_mounted()) GTEST_SKIP() << no_mount;
    run.set_steps(48);  // writes the run file, on the disk
    if (has_checkpoint) run.finish(ranks);
    run.set_steps(96);
    disk.leave(static_cast<std::uintmax_t>(room * bytes));
    const Finished full = run.run(ranks);
    EXPECT_EQ(full.code, 74) << full.err;
    EXPECT_THAT(full.err, ::testing::ContainsRegex("[0-9]+ bytes are needed|needs [0-9]+ bytes"));
    EXPECT_THAT(full.err, ::testing::HasSubstr("start the run again"));
    ++tally().faults_injected;
    disk.make_room();
    run.finish(ranks);
    EXPECT_TRUE(run.exit_record().at("rejected_checkpoints").empty()) << run.exit_record();
    EXPECT_EQ(run.fingerprint(), undisturbed.fingerprint());
  }
}

TEST(DiskFull, StopsTheSolverWith74AndDamagesNothing) { expect_74_and_no_damage(1, false, {0, 0.01, 0.5, 0.9}); }
TEST(DiskFull, StopsAContinuedRunWith74AndDamagesNothing) { expect_74_and_no_damage(1, true, {0.01, 0.5}); }
TEST(DiskFull, StopsTheSolverOnTwoRanksToo) { expect_74_and_no_damage(2, true, {0.5}); }

TEST(DiskFull, SnapshotsThatFillItStopTheSolverWith74AndDamageNothing) {
  const auto with_a_snapshot_a_step = [](BusyRun& run) { run.set("output.snapshot_interval_s", "1.25e-6"); };
  BusyRun undisturbed;
  with_a_snapshot_a_step(undisturbed);
  undisturbed.finish();
  BusyRun run;
  const SmallDisk disk(run.directory());
  if (!disk.is_mounted()) GTEST_SKIP() << no_mount;
  with_a_snapshot_a_step(run);
  disk.leave(8 << 20);  // three checkpoints and a dozen of 49 snapshots
  const Finished full = run.run();
  EXPECT_EQ(full.code, 74) << full.err;
  EXPECT_THAT(full.err, ::testing::ContainsRegex("snapshots.*([0-9]+ bytes are needed|needs [0-9]+ bytes)"));
  ++tally().faults_injected;
  disk.make_room();
  run.finish();
  EXPECT_EQ(run.fingerprint(), undisturbed.fingerprint());
}

class FullCampaign : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!disk.is_mounted()) GTEST_SKIP() << no_mount;
    for (const CampaignProgram* made : {&undisturbed, &program}) {
      set_content(made->study(), busy_study(480));
      const auto end = made->init();
      ASSERT_EQ(end.status, 0) << end.err;
    }
    ASSERT_EQ(undisturbed.run().status, 0);
    ++tally().faults_injected;
  }
  /// With room again: what the undisturbed campaign has.
  void expect_undisturbed_end() const {
    EXPECT_EQ(outcome_of(program), outcome_of(undisturbed));
    const auto check = program.rouleau({"verify", "c", "--checkpoints"});
    EXPECT_EQ(check.status, 0) << check.out << check.err;
  }
  [[nodiscard]] bool has_said(const std::string& text) const {
    return program.messages().find(text) != std::string::npos;
  }

  const CampaignProgram undisturbed{ROULEAU_SOLVER}, program{ROULEAU_SOLVER};
  const SmallDisk disk{program.campaign()};
};

TEST_F(FullCampaign, PointsWaitForRoomAndThenStartByThemselves) {
  disk.leave(1 << 20);
  const pid_t manager = program.start({"run", "c"});
  EXPECT_TRUE(eventually([&] { return has_said("Points wait until there is room"); })) << program.messages();
  EXPECT_TRUE(has_said("a start needs")) << program.messages();
  EXPECT_TRUE(has_said("the points left will need")) << "said before anything is started: " << program.messages();
  disk.make_room();
  EXPECT_EQ(CampaignProgram::wait_for(manager), 0) << program.messages();
  expect_undisturbed_end();
}

TEST_F(FullCampaign, DiskThatFillsUpUnderTheSolversIsWaitedOut) {
  const std::uintmax_t bytes = std::filesystem::file_size(undisturbed.run_directory(1) / "checkpoints/000000000480.h5");
  disk.leave((1 << 20) + 5 * bytes / 2);  // a start is allowed, but not even one point comes to its end
  const pid_t manager = program.start({"run", "c"});
  EXPECT_TRUE(eventually([&] { return has_said("exit.json says 74"); })) << program.messages();
  disk.make_room();
  EXPECT_EQ(CampaignProgram::wait_for(manager), 0) << program.messages();
  expect_undisturbed_end();
}

TEST_F(FullCampaign, DiskWithoutAnyRoomStopsTheManagerAndTheSameCommandGoesOn) {
  disk.leave(0);
  const auto full = program.rouleau({"cancel", "-C", "c", "#2"});
  EXPECT_EQ(full.status, 1) << full.err;
  EXPECT_THAT(full.err, ::testing::ContainsRegex("free space|has room|have room|make room"));
  disk.make_room();
  const auto end = program.run();
  EXPECT_EQ(end.status, 0) << end.err;
  tally().manual_steps += end.status != 0 ? 1 : 0;
  expect_undisturbed_end();
}

}  // namespace
}  // namespace rouleau::testing
