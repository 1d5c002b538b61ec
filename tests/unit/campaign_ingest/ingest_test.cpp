// SPDX-License-Identifier: BSD-3-Clause
// Ingest is repeatable, follows a log that is cut back, and keeps to one point's trouble.
#include "ingest/ingest.hpp"

#include <gmock/gmock.h>

#include "written_campaign.hpp"

namespace rouleau::campaign {
namespace {

using ::rouleau::testing::set_content;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::log_header;
using testing::log_line;
using testing::log_lines;

class IngestTest : public ::testing::Test {
 protected:
  IngestTest() : store_(Store::create(campaign_.path() / "campaign.db", {"small", "", "", 1.7e9, "0", "0"})) {
    for (const int ordinal : {1, 2}) {
      const Point point = campaign_.add_point(ordinal);
      store_.add_point(row_of(point), parameter_rows_of(point), "added");
    }
  }
  Ingested ingest(const std::string& key) { return ingest_point(store_, campaign_.path(), key); }

  testing::WrittenCampaign campaign_;
  Store store_;
  std::string key_ = "000000abc001", other_ = "000000abc002";
};

TEST_F(IngestTest, TwiceIsOnce) {
  set_content(campaign_.log(key_), log_header + log_lines(0, 50000));
  EXPECT_EQ(ingest(key_).new_samples, 501);
  const std::vector<SampleRow> samples = store_.samples(key_);
  const std::vector<ResultRow> results = store_.results(key_);
  const Ingested again = ingest(key_);
  EXPECT_EQ(again.new_samples, 0);
  EXPECT_FALSE(again.reread);
  EXPECT_EQ(store_.samples(key_), samples);
  EXPECT_EQ(store_.results(key_), results);
  EXPECT_EQ(results.size(), 1U);
}

TEST_F(IngestTest, ManyPartsGiveTheBitsOfOneReading) {
  for (std::int64_t end = 0; end <= 60000; end += 5000) {
    set_content(campaign_.log(key_), log_header + log_lines(0, end));
    ingest(key_);
  }
  set_content(campaign_.log(other_), log_header + log_lines(0, 60000));
  ingest(other_);
  EXPECT_EQ(store_.samples(key_), store_.samples(other_));
  ResultRow one = store_.results(key_).at(0), whole = store_.results(other_).at(0);
  whole.point = one.point;
  EXPECT_EQ(one, whole);
}

TEST_F(IngestTest, RowsBehindACutAreGoneAndReadAgain) {
  set_content(campaign_.log(key_), log_header + log_lines(0, 50000));
  ingest(key_);
  set_content(campaign_.log(key_), log_header + log_lines(0, 30000));
  EXPECT_TRUE(ingest(key_).reread);
  EXPECT_EQ(store_.samples(key_).back().step, 30000);
  EXPECT_EQ(store_.results(key_).at(0).step, 30000);
  set_content(campaign_.log(key_), log_header + log_lines(0, 60000));
  ingest(key_);
  EXPECT_EQ(store_.samples(key_).size(), 601U);
}

TEST_F(IngestTest, DamagedFilesAreNamedAndTheRestIsRead) {
  campaign_.add_attempt(key_, 1);
  AttemptRow attempt;
  attempt.point = key_;
  attempt.number = 1;
  store_.put_attempt(attempt);
  set_content(campaign_.run(key_) / "attempts" / "1" / "exit.json", "{ torn");
  set_content(campaign_.log(key_), log_header + log_lines(0, 1000) + "1100,rubbish\n");
  const Ingested done = ingest(key_);
  EXPECT_EQ(done.new_samples, 11);
  EXPECT_THAT(done.warnings, ::testing::ElementsAre(HasSubstr("samples.csv"), HasSubstr("exit.json")));
  EXPECT_EQ(store_.attempts(key_).at(0).pid, 4711);  // process.json was good
  set_content(campaign_.log(other_), log_header + log_lines(0, 1000));
  EXPECT_THAT(ingest(other_).warnings, IsEmpty());
}

TEST_F(IngestTest, AttemptIsFilledInWithoutTouchingItsBookkeeping) {
  campaign_.add_attempt(key_, 1, 800);
  campaign_.end_attempt(key_, 1, 75, 800, 1200);
  AttemptRow attempt;
  attempt.point = key_;
  attempt.number = 1;
  attempt.token = "ours";
  attempt.cores = "0,1";
  attempt.state = AttemptState::launched;
  store_.put_attempt(attempt);
  ingest(key_);
  const AttemptRow filled = store_.attempts(key_).at(0);
  EXPECT_EQ(filled.token, "ours");
  EXPECT_EQ(filled.cores, "0,1");
  EXPECT_EQ(filled.state, AttemptState::launched);
  EXPECT_EQ(filled.exit_code, 75);
  EXPECT_EQ(filled.mlups, 20.5);
  EXPECT_EQ(filled.checkpoint_at_start, 800);
}

TEST_F(IngestTest, AttemptThatTheDatabaseDoesNotKnowIsLeftToItsManager) {
  campaign_.add_attempt(key_, 1);
  ingest(key_);
  EXPECT_TRUE(store_.attempts(key_).empty());
}

TEST_F(IngestTest, ValuesThatAreNotFiniteAreStoredAsUnsetWithAFlag) {
  set_content(campaign_.log(key_), log_header + log_line(0, "0.5") + log_line(100, "nan"));
  ingest(key_);
  EXPECT_EQ(store_.samples(key_).at(1).d_um, std::nullopt);
  EXPECT_FALSE(store_.samples(key_).at(1).finite);
  EXPECT_EQ(store_.results(key_).at(0).phase, "undecided");
}

TEST_F(IngestTest, OtherThresholdsChangeAllResultsAtOnce) {
  set_content(campaign_.log(key_), log_header + log_lines(0, 100000));
  ingest(key_);
  EXPECT_EQ(store_.results(key_).at(0).phase, "slipper");
  Analysis analysis;
  analysis.croissant_d_um = 2;
  analysis.slipper_d_um = 3;
  store_analysis(store_, analysis);
  EXPECT_EQ(store_.results(key_).at(0).phase, "croissant");
  EXPECT_EQ(stored_analysis(store_).slipper_d_um, 3);
}

}  // namespace
}  // namespace rouleau::campaign
