// SPDX-License-Identifier: BSD-3-Clause
// A damaged or lost database: `verify` says so, `rebuild` makes it what it was, from the run directories alone.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "crash/damage/figures.hpp"
#include "crash/damage/real_campaign.hpp"
#include "study/error.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignOutcome;
using rouleau::testing::CampaignProgram;
using rouleau::testing::content_of;
using rouleau::testing::eventually;
using rouleau::testing::figures;
using rouleau::testing::RealCampaign;
using rouleau::testing::set_content;

class DamagedDatabase : public ::testing::Test {
 protected:
  DamagedDatabase() {
    program_.finish();
    sound_ = outcome_of(program_);
  }
  [[nodiscard]] std::filesystem::path file() const { return program_.campaign() / "campaign.db"; }

  [[nodiscard]] bool is_as_before() const {
    try {
      return outcome_of(program_) == sound_;
    } catch (const Error&) {
      return false;
    }
  }
  void expect_rebuilt(const std::string& what) const {
    const auto rebuilt = program_.rouleau({"rebuild", "c"});
    EXPECT_EQ(rebuilt.status, 0) << what << ": " << rebuilt.err;
    EXPECT_TRUE(is_as_before()) << what;
    figures().wrong_resumes += is_as_before() ? 0 : 1;
  }

  RealCampaign program_;
  CampaignOutcome sound_;
};

TEST_F(DamagedDatabase, AnywhereIsFoundOrHarmlessAndRebuiltAsItWas) {
  const std::string sound = content_of(file());
  const int count = rouleau::testing::places(10, 150);
  for (int i = 0; i < count; ++i) {
    const std::size_t place = rouleau::testing::spread(i, sound.size());
    const std::string what = fmt::format("place {}, kind {}", place, i % 5);
    set_content(file(), rouleau::testing::damaged(sound, place, i));
    ++figures().damage_positions;
    for (const char* verb : {"status", "query", "verify"}) {
      const auto answer = program_.rouleau({verb, "c"});
      EXPECT_LT(answer.status, 8) << what << ": " << verb << " died: " << answer.err;
      if (answer.status != 0) {
        EXPECT_NE(answer.err + answer.out, "") << what << ": " << verb << " says nothing";
      }
      const bool is_missed = std::string(verb) == "verify" && answer.status == 0 && !is_as_before();
      figures().undetected += is_missed ? 1 : 0;
      EXPECT_FALSE(is_missed) << what;
    }
    expect_rebuilt(what);
  }
}

// The database keeps the text of its tables: with one changed byte a column has another name. Such damage once ended
// with 1, as a statement that SQLite could not understand.
TEST_F(DamagedDatabase, InTheDefinitionOfATableIsNamedAsDamage) {
  std::string content = content_of(file());
  const std::size_t place = content.find("resumed_from");
  ASSERT_NE(place, std::string::npos);
  content[place] = 'x';
  set_content(file(), content);
  const auto answer = program_.rouleau({"sync", "c"});
  EXPECT_EQ(answer.status, static_cast<int>(Exit::damaged)) << answer.err;
  EXPECT_THAT(answer.err, ::testing::HasSubstr("`rouleau rebuild`"));
  expect_rebuilt("the name of a column");
}

TEST_F(DamagedDatabase, LostIsRebuiltAsItWas) {
  std::filesystem::remove(file());
  expect_rebuilt("lost");
  const auto checked = program_.rouleau({"verify", "c"});
  EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
}

// A point that is done, one whose job lives, and room for a second job.
TEST(DamagedDatabaseUnderAJob, SyncWorksOrNamesRebuildAndStartsNothingTwice) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1, 8", CampaignProgram::execution());
  ASSERT_EQ(program.init().status, 0);
  program.script(2, "hang 70\n-\n");
  ASSERT_EQ(program.rouleau({"sync", "c"}).status, 0);
  ASSERT_TRUE(eventually([&] { return program.jobs().size() == 1; }));
  ASSERT_EQ(program.rouleau({"sync", "c"}).status, 0);
  ASSERT_EQ(program.state(1), State::done);
  const std::filesystem::path file = program.campaign() / "campaign.db", run = program.run_directory(2);
  const std::string key = program.point(2).key, sound = content_of(file);

  const int count = rouleau::testing::places(20, 400);
  for (int i = 0; i < count; ++i) {
    const std::size_t place = rouleau::testing::spread(i, sound.size());
    SCOPED_TRACE(fmt::format("place {}, kind {}", place, i % 5));
    std::filesystem::remove(file.string() + "-journal");
    set_content(file, rouleau::testing::damaged(sound, place, i));
    ++figures().damage_positions;
    const auto answer = program.rouleau({"sync", "c"});
    EXPECT_EQ(program.jobs().size(), 1U) << answer.err;
    EXPECT_FALSE(std::filesystem::exists(run / "attempts" / "2")) << answer.err;
    EXPECT_FALSE(std::filesystem::exists(run / "result.json")) << answer.err;
    if (answer.status == 0) {
      EXPECT_NE(program.store().point(key).value().state, State::done);
    } else {
      EXPECT_EQ(answer.status, static_cast<int>(Exit::damaged)) << answer.err;
      EXPECT_THAT(answer.err, ::testing::HasSubstr("`rouleau rebuild`"));
    }
  }

  const auto rebuilt = program.rouleau({"rebuild", "c"});
  EXPECT_EQ(rebuilt.status, 0) << rebuilt.err;
  ASSERT_EQ(program.jobs().size(), 1U);
  ::kill(program.jobs().front(), SIGKILL);
  const auto end = program.run();
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_EQ(program.state(2), State::done);
}

}  // namespace
}  // namespace rouleau::campaign
