// SPDX-License-Identifier: BSD-3-Clause
// `rouleau init`: first, again, changed.
#include <gmock/gmock.h>

#include "study/point.hpp"
#include "support/campaign_program.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using rouleau::testing::content_of;
using rouleau::testing::set_content;
using ::testing::HasSubstr;

/// All files below a directory with their content, but for the lock and the database.
std::map<std::string, std::string> files_of(const std::filesystem::path& directory) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
    const std::string name = entry.path().lexically_relative(directory).string();
    if (entry.is_regular_file() && name != ".lock" && name != "campaign.db") files[name] = content_of(entry.path());
  }
  return files;
}

TEST(CampaignInit, MakesAPointADirectory) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1, 4:5:0.5");
  const auto capture = program.init();
  ASSERT_EQ(capture.status, 0) << capture.err;
  const std::vector<PointRow> points = program.store().points();
  ASSERT_EQ(points.size(), 4U);
  for (const PointRow& point : points) {
    EXPECT_EQ(point.state, State::waiting);
    EXPECT_EQ(point.end_step, 100);
    const auto run = program.campaign() / "points" / point.key;
    EXPECT_EQ(read_point(run / "point.json").key, point.key);
    EXPECT_THAT(content_of(run / "run.ini"), HasSubstr("[fluid]\nlambda = "));
  }
  EXPECT_EQ(content_of(program.campaign() / "study.ini"), content_of(program.study()));
}

TEST(CampaignInit, AgainChangesNothing) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1, 5");
  ASSERT_EQ(program.init().status, 0);
  const auto before = files_of(program.campaign());
  ASSERT_EQ(program.init().status, 0);
  EXPECT_EQ(files_of(program.campaign()), before);
  EXPECT_EQ(program.store().points().size(), 2U);
}

TEST(CampaignInit, AddedValuesAddPointsAndKeepOldOnes) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1, 5");
  ASSERT_EQ(program.init().status, 0);
  ASSERT_EQ(program.run().status, 0);
  const std::vector<PointRow> before = program.store().points();
  program.write_study("fluid.lambda = 0.5, 1.0, 3, 5.00");
  const auto capture = program.init();
  ASSERT_EQ(capture.status, 0) << capture.err;
  EXPECT_THAT(capture.err, HasSubstr("4 points (2 new, 2 kept"));
  const std::vector<PointRow> after = program.store().points();
  ASSERT_EQ(after.size(), 4U);
  EXPECT_EQ(after[0], before[0]);
  EXPECT_EQ(after[1], before[1]);
  EXPECT_EQ(after[2].state, State::waiting);
}

TEST(CampaignInit, PointsThatLeaveAreKeptOnlyAfterYes) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1, 5");
  ASSERT_EQ(program.init().status, 0);
  program.write_study("fluid.lambda = 5, 6");
  const auto before = files_of(program.campaign());
  const auto refused = program.init();
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(
      refused.err,
      HasSubstr("1 points of the campaign are not in the study any more, and 1 new ones come: #1 (fluid.lambda = 1)"));
  EXPECT_EQ(files_of(program.campaign()), before) << "a refusal changes nothing";
  const auto taken = program.rouleau({"init", "study.ini", "c", "--yes"});
  ASSERT_EQ(taken.status, 0) << taken.err;
  EXPECT_FALSE(program.point(1).in_study);
  EXPECT_TRUE(program.point(2).in_study);
  ASSERT_EQ(program.run().status, 0);
  EXPECT_EQ(program.state(1), State::waiting) << "points out of the study are not run";
  EXPECT_EQ(program.state(3), State::done);

  program.write_study("fluid.lambda = 1, 5, 6");
  ASSERT_EQ(program.init().status, 0);
  EXPECT_TRUE(program.point(1).in_study) << "and come back as they were";
}

TEST(CampaignInit, LaterEndLetsFinishedPointsGoOn) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 5");
  ASSERT_EQ(program.init().status, 0);
  ASSERT_EQ(program.run().status, 0);
  const std::string first = content_of(program.run_directory(1) / "samples.csv");
  program.write_study("fluid.lambda = 5", "", "0.02");
  const auto capture = program.init();
  ASSERT_EQ(capture.status, 0) << capture.err;
  EXPECT_EQ(program.state(1), State::stopped);
  EXPECT_FALSE(std::filesystem::exists(program.run_directory(1) / "result.json"));
  ASSERT_EQ(program.run().status, 0);
  EXPECT_EQ(program.state(1), State::done);
  EXPECT_EQ(program.store().samples(program.point(1).key).back().step, 200);
  EXPECT_TRUE(content_of(program.run_directory(1) / "samples.csv").starts_with(first)) << "nothing is run twice";
}

TEST(CampaignInit, OtherFilesAreNotMixedWith) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 5");
  std::filesystem::create_directory(program.campaign());
  set_content(program.campaign() / "thesis.tex", "x");
  const auto capture = program.init();
  EXPECT_EQ(capture.status, 2);
  EXPECT_THAT(capture.err, HasSubstr("holds other files and no campaign"));
}

TEST(CampaignInit, RefusedStudyLeavesNothingBehind) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 5, 1000");
  const auto capture = program.init();
  EXPECT_EQ(capture.status, 2);
  EXPECT_EQ(
      capture.err,
      "study.ini:10: fluid.lambda = 1000 is out of range. Give a number from 0.1 to 100. (at fluid.lambda = 1000)\n");
  EXPECT_FALSE(std::filesystem::exists(program.campaign()));
}

TEST(CampaignInit, KilledInTheMiddleIsSimplyDoneAgain) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 5");
  // What a kill leaves: the lock, a directory without its file, half a database beside.
  std::filesystem::create_directories(program.campaign() / "points" / "0123456789ab");
  set_content(program.campaign() / ".lock", "");
  set_content(program.campaign() / "campaign.db.tmp", "SQLite form");
  const auto capture = program.init();
  ASSERT_EQ(capture.status, 0) << capture.err;
  EXPECT_EQ(program.run().status, 0);
}

TEST(CampaignInit, CopiesNamedFilesSoThatTheCampaignCanMove) {
  const CampaignProgram program;
  set_content(program.path() / "cell.off", "OFF");
  program.write_study("fluid.lambda = 5", "[cell]\nmesh_file = cell.off\n");
  ASSERT_EQ(program.init().status, 0);
  const std::string key = program.point(1).key;
  std::filesystem::remove(program.path() / "cell.off");
  std::filesystem::rename(program.campaign(), program.path() / "moved");
  ASSERT_EQ(program.rouleau({"run", "moved"}).status, 0);
  const auto again = program.rouleau({"init", "moved/study.ini", "moved"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_THAT(again.err, HasSubstr("1 points (0 new, 1 kept"));
  std::filesystem::rename(program.path() / "moved", program.campaign());
  EXPECT_EQ(program.point(1).key, key) << "the content counts, not the name";
}

TEST(CampaignInit, DamagedPointFileIsWrittenAnew) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1, 5");
  ASSERT_EQ(program.init().status, 0);
  const std::string before = content_of(program.run_directory(2) / "point.json");
  set_content(program.run_directory(2) / "point.json", "{");
  const auto capture = program.init();
  ASSERT_EQ(capture.status, 0) << capture.err;
  EXPECT_EQ(content_of(program.run_directory(2) / "point.json"), before);
}

}  // namespace
}  // namespace rouleau::campaign
