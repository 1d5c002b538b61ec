// SPDX-License-Identifier: BSD-3-Clause
// `rouleau plan`.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "study/point.hpp"
#include "support/campaign_program.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using rouleau::testing::set_content;
using ::testing::HasSubstr;
using ::testing::Not;

nlohmann::json rows_of(const std::string& text) { return nlohmann::json::parse(text).at("rows"); }

TEST(CampaignPlan, OfAStudyFileNeedsNoCampaignAndMakesNone) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1, 5");
  const auto capture = program.rouleau({"plan", "study.ini", "--no-calibrate", "--format", "json"});
  ASSERT_EQ(capture.status, 0) << capture.err;
  const auto rows = rows_of(capture.out);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0]["steps"], 100);
  EXPECT_EQ(rows[2]["point"], "total");
  EXPECT_EQ(rows[2]["steps_left"], 200);
  EXPECT_TRUE(rows[2]["core_hours"].is_null()) << "an unmeasured speed is not invented";
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(program.path()), {}), 1)
      << "only the study file is there";
}

TEST(CampaignPlan, MeasuresTheSpeedOnAScratchCopy) {
  const CampaignProgram program;
  rouleau::testing::CampaignProgram::set_speed(1000, 50);
  program.write_study("fluid.lambda = 1, 5");
  ASSERT_EQ(program.init().status, 0);
  const auto capture = program.rouleau({"plan", "c", "--calibrate-s", "0.2", "--format", "json"});
  ASSERT_EQ(capture.status, 0) << capture.err;
  EXPECT_THAT(capture.err, HasSubstr("speed measured on fluid.lambda = 1"));
  const auto rows = rows_of(capture.out);
  // 200 steps of at least 1 ms on one core; a sleeping step may take a few times longer on a busy machine.
  const double seconds = rows[2]["core_hours"].get<double>() * 3600;
  EXPECT_GT(seconds, 0.2);
  EXPECT_LT(seconds, 4.0);
  EXPECT_FALSE(std::filesystem::exists(program.run_directory(1) / "attempts")) << "the campaign is not touched";
}

TEST(CampaignPlan, UsesTheSpeedOfWhatRanAndCountsOnlyWhatIsLeft) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1, 5");
  ASSERT_EQ(program.init().status, 0);
  ASSERT_EQ(program.run().status, 0);
  program.write_study("fluid.lambda = 1, 3, 5");
  ASSERT_EQ(program.init().status, 0);
  const auto capture = program.rouleau({"plan", "c", "--format", "json"});
  ASSERT_EQ(capture.status, 0) << capture.err;
  EXPECT_THAT(capture.err, HasSubstr("as measured by 2 points"));
  const auto rows = rows_of(capture.out);
  EXPECT_EQ(rows[0]["steps_left"], 0);
  EXPECT_EQ(rows[2]["steps_left"], 100);
  EXPECT_GT(rows[3]["core_hours"].get<double>(), 0);
}

TEST(CampaignPlan, SaysThatCheckpointsCannotFit) {
  const CampaignProgram program;
  // 99 points that keep 2 TB of checkpoints each.
  program.write_study("fluid.lambda = 1:50:0.5", "[output]\ncheckpoints_kept = 2000000000\n");
  const auto capture = program.rouleau({"plan", "study.ini", "--no-calibrate"});
  ASSERT_EQ(capture.status, 0) << capture.err;
  EXPECT_THAT(capture.err, HasSubstr("NOT ENOUGH"));
}

/// Lets a point write so many bytes of snapshots until its end.
void set_snapshot_bytes(const CampaignProgram& program, int ordinal, std::uintmax_t bytes) {
  const std::filesystem::path file = program.run_directory(ordinal) / "point.json";
  Point point = read_point(file);
  point.facts.snapshot_bytes = static_cast<std::int64_t>(bytes);
  write_point(file, point);
}

// All that the campaign takes in the end was compared with what is free now, as if nothing of it were there already.
TEST(CampaignPlan, NeedsNoRoomForWhatIsDoneOrOnTheDisk) {
  constexpr std::uintmax_t GiB = std::uintmax_t{1} << 30U;
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1");
  ASSERT_EQ(program.init().status, 0);
  ASSERT_EQ(program.run().status, 0);
  program.write_study("fluid.lambda = 1, 5");
  ASSERT_EQ(program.init().status, 0);
  const std::uintmax_t free = std::filesystem::space(program.path()).available;
  set_snapshot_bytes(program, 1, free + GiB);
  const auto verdict = [&] { return program.rouleau({"plan", "c", "--no-calibrate"}).err; };
  EXPECT_THAT(verdict(), Not(HasSubstr("NOT ENOUGH"))) << "the first point is done";
  set_snapshot_bytes(program, 2, free + GiB);
  EXPECT_THAT(verdict(), HasSubstr("NOT ENOUGH"));

  const std::filesystem::path snapshots = program.run_directory(2) / "snapshots";
  std::filesystem::create_directories(snapshots);
  set_content(snapshots / "000000000010.h5", "");
  std::filesystem::resize_file(snapshots / "000000000010.h5", 2 * GiB);  // takes no room: nothing is written
  EXPECT_THAT(verdict(), Not(HasSubstr("NOT ENOUGH")));
  const auto finished = program.run();
  EXPECT_EQ(finished.status, 0);
  EXPECT_THAT(finished.err, Not(HasSubstr("will need"))) << "`run` reckons as `plan` does";
}

TEST(CampaignPlan, SpeaksCsv) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1");
  const auto capture = program.rouleau({"plan", "study.ini", "--no-calibrate", "-q", "--format", "csv"});
  EXPECT_EQ(capture.err, "");
  EXPECT_THAT(capture.out, HasSubstr("point,parameters,state,steps,steps_left,core_hours,hours,disk_MiB\r\n#1,fluid."
                                     "lambda = 1,waiting,100,100,,,"));
}

TEST(CampaignPlan, BadStudyIsRefusedLikeByInit) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1000");
  EXPECT_EQ(program.rouleau({"plan", "study.ini"}).status, 2);
}

}  // namespace
}  // namespace rouleau::campaign
