// SPDX-License-Identifier: BSD-3-Clause
// Typed rows go in and come out; states change once and leave their evidence.
#include "store/store.hpp"

#include <gmock/gmock.h>

#include "sample_rows.hpp"
#include "study/error.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::campaign {
namespace {

using ::rouleau::testing::TemporaryDirectory;
using ::testing::ElementsAre;
using ::testing::Field;

class StoreTest : public ::testing::Test {
 protected:
  StoreTest() : store_(Store::create(directory_.path() / "campaign.db", testing::a_campaign())) {
    for (const int ordinal : {1, 2}) {
      const PointRow point = testing::a_point(ordinal);
      store_.add_point(point, testing::its_parameters(point), "added by the study");
    }
  }

  TemporaryDirectory directory_;
  Store store_;
  std::string key_ = testing::a_point(1).key;
};

TEST_F(StoreTest, PointsComeBackWithTheirParameters) {
  EXPECT_THAT(store_.points(), ElementsAre(testing::a_point(1), testing::a_point(2)));
  EXPECT_EQ(store_.parameters(key_), testing::its_parameters(testing::a_point(1)));
  EXPECT_EQ(store_.point("no such key"), std::nullopt);
}

TEST_F(StoreTest, PointIsNotAddedTwice) {
  EXPECT_THROW(store_.add_point(testing::a_point(1), {}, "again"), Error);
  EXPECT_EQ(store_.events(key_).size(), 1U);
}

TEST_F(StoreTest, StateChangesOnlyFromTheStateExpected) {
  EXPECT_TRUE(store_.change_state(key_, State::waiting, State::running, "attempt 1 was started", 1));
  EXPECT_FALSE(store_.change_state(key_, State::waiting, State::cancelled, "too late"));
  EXPECT_EQ(store_.point(key_)->state, State::running);
  const std::vector<EventRow> events = store_.events(key_);
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].from, std::nullopt);
  EXPECT_EQ(events[1].from, State::waiting);
  EXPECT_EQ(events[1].to, State::running);
  EXPECT_EQ(events[1].attempt, 1);
  EXPECT_EQ(events[1].evidence, "attempt 1 was started");
}

TEST_F(StoreTest, StateChangeInAnAbandonedTransactionLeavesNoEvent) {
  {
    const Transaction transaction = store_.begin();
    store_.change_state(key_, State::waiting, State::running, "never happened");
  }
  EXPECT_EQ(store_.point(key_)->state, State::waiting);
  EXPECT_EQ(store_.events(key_).size(), 1U);
}

TEST_F(StoreTest, EveryStateIsStoredUnderItsWord) {
  State from = State::waiting;
  for (std::size_t i = 1; i < state_words.size(); ++i) {
    const State to = static_cast<State>(i);
    ASSERT_TRUE(store_.change_state(key_, from, to, "test"));
    EXPECT_EQ(store_.point(key_)->state, to);
    from = to;
  }
}

TEST_F(StoreTest, AttemptsComeBackAndAreReplaced) {
  AttemptRow attempt;
  attempt.point = key_;
  attempt.number = 1;
  attempt.token = "t";
  attempt.host = "n1";
  attempt.pid = 4711;
  attempt.ranks = 2;
  attempt.cores = "0,1";
  attempt.started_unix_s = 1.7e9;
  attempt.checkpoint_at_start = 400;
  store_.put_attempt(attempt);
  EXPECT_THAT(store_.open_attempts(), ElementsAre(attempt));
  attempt.state = AttemptState::ended;
  attempt.ended_unix_s = 1.7e9 + 60;
  attempt.exit_code = 75;
  attempt.step = 800;
  attempt.wall_s = 59.5;
  attempt.mlups = 21.3;
  store_.put_attempt(attempt);
  EXPECT_THAT(store_.attempts(key_), ElementsAre(attempt));
  EXPECT_EQ(store_.newest_attempt(key_), attempt);
  EXPECT_TRUE(store_.open_attempts().empty());
}

TEST_F(StoreTest, SamplesAreStoredOnceAndBitByBit) {
  SampleRow broken = testing::a_sample(200, 0);
  broken.d_um.reset();
  broken.finite = false;
  const std::vector<SampleRow> samples = {testing::a_sample(0, 0.1 + 0.2), testing::a_sample(100, 1.0 / 3), broken};
  store_.put_samples(key_, samples);
  store_.put_samples(key_, samples);
  EXPECT_EQ(store_.samples(key_), samples);
  EXPECT_TRUE(store_.samples(testing::a_point(2).key).empty());
  store_.delete_samples(key_);
  EXPECT_TRUE(store_.samples(key_).empty());
}

TEST_F(StoreTest, SamplesOfAnUnknownPointAreRefused) {
  const std::vector<SampleRow> samples = {testing::a_sample(0, 0.5)};
  EXPECT_THROW(store_.put_samples("ffffffffffff", samples), Error);
}

TEST_F(StoreTest, TemporaryResultsOfAReaderStayItsOwn) {
  const Store reader = Store::open_reader(directory_.path() / "campaign.db");
  Store other = Store::open_reader(directory_.path() / "campaign.db");
  ResultRow result;
  result.point = key_;
  result.window_s = 0.1;
  result.d_mean_um = 0.5;
  result.phase = "slipper";
  const std::string table = other.put_temporary_results({&result, 1});
  EXPECT_EQ(other.database().select_integer("SELECT count(*) FROM " + table), 1);
  EXPECT_TRUE(reader.results(key_).empty());
  EXPECT_THROW(other.set_setting("a", "b"), Error);  // it is a reader still
}

TEST_F(StoreTest, SettingsAndStudyAreReplaced) {
  store_.set_setting("analysis.window_s", "0.2");
  store_.set_setting("analysis.window_s", "0.1");
  EXPECT_EQ(store_.setting("analysis.window_s"), "0.1");
  EXPECT_EQ(store_.setting("other"), std::nullopt);
  store_.set_study("second", "text", "digest");
  EXPECT_THAT(store_.campaign(), Field(&CampaignRow::name, "second"));
}

TEST(IsoUtc, IsTheTimeInUtcToTheSecond) { EXPECT_EQ(iso_utc(1700000000.9), "2023-11-14T22:13:20Z"); }

}  // namespace
}  // namespace rouleau::campaign
