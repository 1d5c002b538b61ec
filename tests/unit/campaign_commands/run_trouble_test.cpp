// SPDX-License-Identifier: BSD-3-Clause
// `rouleau run` when its database cannot be written for a while, or not any more; and when points fail alike.
#include <gmock/gmock.h>

#include <fstream>
#include <optional>

#include "support/campaign_program.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using rouleau::testing::eventually;
using ::testing::HasSubstr;

/// How often a text occurs in another.
int count_of(const std::string& part, const std::string& text) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

void expect_all_done_at_the_first_attempt(const CampaignProgram& program) {
  const Store store = program.store();
  for (const PointRow& point : store.points()) {
    EXPECT_EQ(point.state, State::done) << point.ordinal;
    EXPECT_EQ(store.attempts(point.key).size(), 1U) << point.ordinal;
    EXPECT_TRUE(std::filesystem::exists(program.campaign() / "points" / point.key / "result.json"));
  }
  const auto check = program.rouleau({"verify", "c"});
  EXPECT_EQ(check.status, 0) << check.out << check.err;
}

// The error of such a pass once ended the manager with 1: nothing more was started.
TEST(CampaignRunTrouble, ReaderThatKeepsTheDatabaseLockedIsWaitedOut) {
  const CampaignProgram program;
  CampaignProgram::set_speed(10000, 50);
  program.write_study("fluid.lambda = 1:4:1", CampaignProgram::execution());
  ASSERT_EQ(program.init().status, 0);
  const pid_t run = program.start({"run", "c"});
  ASSERT_TRUE(eventually([&] { return program.jobs().size() == 2; }));
  {
    const Store store = program.store();
    const Snapshot reader(store.database());
    EXPECT_EQ(store.points().size(), 4U);  // from here on it holds its lock, as `sqlite3 ... | less` does
    EXPECT_TRUE(eventually([&] { return program.messages().find("keeps it open") != std::string::npos; }))
        << program.messages();
  }
  EXPECT_EQ(CampaignProgram::wait_for(run), 0) << program.messages();
  EXPECT_EQ(count_of("keeps it open", program.messages()), 1) << program.messages();
  expect_all_done_at_the_first_attempt(program);
}

TEST(CampaignRunTrouble, CtrlCReachesAllJobsWhileTheDatabaseIsLocked) {
  const CampaignProgram program;
  CampaignProgram::set_speed(10000, 1000);
  program.write_study("fluid.lambda = 1, 2", CampaignProgram::execution(), "1");
  ASSERT_EQ(program.init().status, 0);
  program.script(1, "exit 70 100\n");  // its end cannot be recorded, and the other job comes behind it
  const pid_t run = program.start({"run", "c"});
  ASSERT_TRUE(
      eventually([&] { return std::filesystem::exists(program.run_directory(2) / "attempts/1/started.json"); }));
  std::optional<Store> store = program.store();
  std::optional<Snapshot> reader(std::in_place, store->database());
  EXPECT_EQ(store->points().size(), 2U);
  ASSERT_TRUE(eventually([&] { return program.messages().find("keeps it open") != std::string::npos; }))
      << program.messages();
  ::kill(run, SIGINT);
  const bool is_asked = eventually([&] { return program.messages().find("stopping") != std::string::npos; });
  EXPECT_TRUE(is_asked) << program.messages();
  EXPECT_TRUE(eventually([&] { return program.jobs().empty(); }));
  reader.reset();
  EXPECT_EQ(CampaignProgram::wait_for(run), 130) << program.messages();
  EXPECT_EQ(program.state(2), State::stopped);
}

// Its damage was once told point by point, for ever, or ended it with 1 like any other trouble.
TEST(CampaignRunTrouble, DamagedDatabaseEndsItWith7AndNamesRebuild) {
  const CampaignProgram program;
  CampaignProgram::set_speed(10000, 50);
  program.write_study("fluid.lambda = 1, 2, 3", CampaignProgram::execution());
  ASSERT_EQ(program.init().status, 0);
  const pid_t run = program.start({"run", "c"});
  ASSERT_TRUE(eventually([&] { return program.jobs().size() == 2; }));
  {
    // Between two writes of the manager's: one that is under way has the page in memory and writes it back, sound.
    Store store = Store::open(program.campaign() / "campaign.db");
    const Transaction nobody_writes = store.begin();
    std::fstream(program.campaign() / "campaign.db", std::ios::in | std::ios::out | std::ios::binary)
        << std::string(4096, '#');
  }
  EXPECT_EQ(CampaignProgram::wait_for(run), 7) << program.messages();
  EXPECT_THAT(program.messages(), HasSubstr("`rouleau rebuild`"));
  const auto rebuilt = program.rouleau({"rebuild", "c"});
  EXPECT_EQ(rebuilt.status, 0) << rebuilt.err;
  const auto again = program.run();
  EXPECT_EQ(again.status, 0) << again.err;
  expect_all_done_at_the_first_attempt(program);
}

// A job that ended well once lifted the pause, and each further failure said it again with another count.
TEST(CampaignRunTrouble, PauseIsLiftedByNoJobThatStillRunsAndSaidOnce) {
  const CampaignProgram program;
  CampaignProgram::set_speed(20000, 1000);
  program.write_study("fluid.lambda = 1:6:1", "[execution]\njobs = 5\noversubscribe = 1\npause_after_failures = 3\n");
  ASSERT_EQ(program.init().status, 0);
  for (int ordinal = 1; ordinal <= 3; ++ordinal) program.script(ordinal, fmt::format("exit 70 {}\n", ordinal));
  program.script(4, "exit 70 60\n");
  ASSERT_EQ(program.rouleau({"sync", "c"}).status, 0);  // starts five
  const auto has_ended = [&](int ordinal) {
    return std::filesystem::exists(program.run_directory(ordinal) / "attempts/1/exit.json");
  };
  // Before anybody looks, so that the pause is there with the first look.
  ASSERT_TRUE(eventually([&] { return has_ended(1) && has_ended(2) && has_ended(3) && program.jobs().size() <= 2; }));
  const auto capture = program.run();
  EXPECT_EQ(capture.status, 4) << capture.err;
  EXPECT_EQ(program.state(4), State::failed);
  EXPECT_EQ(program.state(5), State::done);
  EXPECT_EQ(program.state(6), State::waiting);
  EXPECT_EQ(count_of("paused", capture.err), 1) << capture.err;
  EXPECT_THAT(capture.err, HasSubstr("paused: 3 points in a row"));
  EXPECT_THAT(program.rouleau({"status", "c"}).err, HasSubstr("paused: 3 points in a row"));
  ASSERT_EQ(program.rouleau({"retry", "--all-failed", "-C", "c"}).status, 0);
  EXPECT_EQ(program.run().status, 0);
}

}  // namespace
}  // namespace rouleau::campaign
