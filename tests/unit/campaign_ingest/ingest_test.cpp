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

/// What may have become of a log since it was read.
std::vector<std::pair<std::string, std::string>> torsos(const std::string& sound) {
  std::string damaged = sound;
  damaged[sound.size() - 200] ^= 1;
  std::string early = damaged;
  early[sound.find("\n1000,") + 8] ^= 1;
  return {{"cut", log_header + log_lines(0, 30000)},
          {"torn", sound.substr(0, sound.size() / 2)},
          {"empty", ""},
          {"header lost", sound.substr(sound.find('\n') + 1)},
          {"damaged at its end", damaged},
          {"damaged twice", early}};
}

TEST_F(IngestTest, SamplesOfAFinishedRunOutliveItsLog) {
  const std::string sound = log_header + log_lines(0, 50000);
  set_content(campaign_.log(key_), sound);
  ingest(key_);
  store_.change_state(key_, State::waiting, State::done, "test");
  const std::vector<SampleRow> samples = store_.samples(key_);
  const std::vector<ResultRow> results = store_.results(key_);
  const auto expect_kept = [&](const std::string& what) {
    const Ingested done = ingest(key_);
    EXPECT_EQ(store_.samples(key_), samples) << what;
    EXPECT_EQ(store_.results(key_), results) << what;
    EXPECT_FALSE(done.reread) << what;
    ASSERT_EQ(done.warnings.size(), 1U) << what;
    EXPECT_THAT(done.warnings[0], HasSubstr("#1: ")) << what;
    EXPECT_THAT(done.warnings[0], HasSubstr(campaign_.log(key_).string())) << what;
    EXPECT_THAT(done.warnings[0], HasSubstr("The database keeps the 501 samples")) << what;
    EXPECT_THAT(done.warnings[0], HasSubstr("Put the file back from a copy")) << what;
  };
  for (const auto& [what, text] : torsos(sound)) {
    set_content(campaign_.log(key_), text);
    expect_kept(what);
  }
  std::filesystem::remove(campaign_.log(key_));
  expect_kept("gone");
  std::filesystem::create_directory(campaign_.log(key_));
  expect_kept("a folder");
  std::filesystem::remove(campaign_.log(key_));
  set_content(campaign_.log(key_), sound);
  EXPECT_THAT(ingest(key_).warnings, IsEmpty()) << "put back";
}

TEST_F(IngestTest, DamagedLogOfAnUnfinishedRunTakesNothingAwayUntilTheRunHasCutItBack) {
  const std::string sound = log_header + log_lines(0, 50000);
  set_content(campaign_.log(key_), sound);
  ingest(key_);
  const std::vector<SampleRow> samples = store_.samples(key_);
  for (const auto& [what, text] : torsos(sound)) {
    if (what == "cut" || what == "torn") continue;  // as a resume leaves it
    set_content(campaign_.log(key_), text);
    EXPECT_THAT(ingest(key_).warnings, ::testing::ElementsAre(HasSubstr("`rouleau run` goes on"))) << what;
    EXPECT_EQ(store_.samples(key_), samples) << what;
  }
  set_content(campaign_.log(key_), log_header);  // started anew at step 0
  EXPECT_THAT(ingest(key_).warnings, IsEmpty());
  EXPECT_TRUE(store_.samples(key_).empty());
  set_content(campaign_.log(key_), sound);
  ingest(key_);
  EXPECT_EQ(store_.samples(key_), samples);
}

TEST_F(IngestTest, RunHasAllItsSamplesIfTheLastThatWasDueIsThereAndAllAreSound) {
  const auto trouble = [&](const std::string& text, std::int64_t end_step) {
    set_content(campaign_.log(key_), text);
    return sample_trouble(store_, campaign_.run(key_), key_, end_step);
  };
  const std::string sound = log_header + log_lines(0, 5000);
  EXPECT_EQ(trouble(sound, 5000), "");
  EXPECT_EQ(trouble(sound, 5099), "") << "the end is no multiple of the interval";
  EXPECT_THAT(trouble(sound, 5100), HasSubstr("last sample is that of step 5000, the run ended at step 5100"));
  EXPECT_THAT(trouble(log_header, 5000), HasSubstr("has no samples"));
  EXPECT_THAT(trouble(sound.substr(0, sound.size() - 9), 5000), HasSubstr("no whole line"));
  EXPECT_THAT(trouble(log_header + log_line(0, "1") + log_line(0, "1", 1) + log_line(100, "1"), 100),
              HasSubstr("has 2 cells at step 0, and 1 at its last, 100"));
  std::string damaged = sound;
  damaged[sound.find("\n1000,") + 8] ^= 1;
  EXPECT_THAT(trouble(damaged, 5000), HasSubstr("line 12 (byte "));
  std::filesystem::remove(campaign_.log(key_));
  EXPECT_THAT(sample_trouble(store_, campaign_.run(key_), key_, 5000), HasSubstr("has no samples"));
}

TEST_F(IngestTest, FewSamplesAreEnoughForALongInterval) {
  set_content(campaign_.log(key_), log_header + log_line(0, "1"));
  EXPECT_THAT(sample_trouble(store_, campaign_.run(key_), key_, 900), HasSubstr("last sample is that of step 0"));
  const PointRow point = *store_.point(key_);
  store_.update_point(point, {{"output.sample_interval_steps", "1000", 1000.0, false}});
  EXPECT_EQ(sample_trouble(store_, campaign_.run(key_), key_, 900), "");
}

TEST_F(IngestTest, StartsInVainAreThoseFromTheSameCheckpoint) {
  const auto started_from = [](std::initializer_list<std::int64_t> checkpoints) {
    std::vector<AttemptRow> attempts;
    for (const std::int64_t checkpoint : checkpoints) attempts.emplace_back().checkpoint_at_start = checkpoint;
    return attempts;
  };
  EXPECT_EQ(starts_in_vain({}), 0);
  EXPECT_EQ(starts_in_vain(started_from({-1})), 1);
  EXPECT_EQ(starts_in_vain(started_from({-1, -1, -1})), 3);
  EXPECT_EQ(starts_in_vain(started_from({-1, -1, 50, 90, 90})), 2);
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
  EXPECT_THAT(done.warnings, ::testing::UnorderedElementsAre(HasSubstr("samples.csv"), HasSubstr("exit.json")));
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
