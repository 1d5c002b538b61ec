// SPDX-License-Identifier: BSD-3-Clause
// A database made anew has the content of the one that was.
#include "ingest/rebuild.hpp"

#include <gmock/gmock.h>

#include "written_campaign.hpp"

namespace rouleau::campaign {
namespace {

using ::rouleau::testing::content_of;
using ::rouleau::testing::set_content;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::log_header;
using testing::log_lines;

class RebuildTest : public ::testing::Test {
 protected:
  /// A point that its attempt brought to its end, with all samples.
  Point finished_point(int ordinal) {
    Point point = campaign_.add_point(ordinal);
    campaign_.add_attempt(point.key, 1);
    campaign_.end_attempt(point.key, 1, 0, 0, 100000);
    set_content(campaign_.log(point.key), log_header + log_lines(0, 100000));
    return point;
  }
  /// Rebuilds into a new file and opens it.
  Store rebuilt(Life life = Life::dead) {
    const std::filesystem::path file = campaign_.path() / fmt::format("rebuilt{}.db", ++count_);
    report_ = rebuild_store(campaign_.path(), file, {"small", "", "", 1.7e9, "0", "0"}, campaign_.study(),
                            [life](const AttemptRow&) { return life; });
    return Store::open(file);
  }
  State state_of(const std::string& key, Life life = Life::dead) { return rebuilt(life).point(key)->state; }

  testing::WrittenCampaign campaign_;
  Rebuilt report_;
  int count_ = 0;
};

/// What a user sees of a database but times and events.
struct Content {
  explicit Content(const Store& store) : points(store.points()) {
    for (const PointRow& point : points) {
      parameters.push_back(store.parameters(point.key));
      attempts.push_back(store.attempts(point.key));
      samples.push_back(store.samples(point.key));
      results.push_back(store.results(point.key));
      marks.push_back(store.sample_mark(point.key));
    }
  }
  std::vector<PointRow> points;
  std::vector<std::vector<ParameterRow>> parameters;
  std::vector<std::vector<AttemptRow>> attempts;
  std::vector<std::vector<SampleRow>> samples;
  std::vector<std::vector<ResultRow>> results;
  std::vector<SampleMark> marks;

  friend bool operator==(const Content&, const Content&) = default;
};

TEST_F(RebuildTest, HasTheContentOfTheDatabaseThatWas) {
  // The one that was: two points, ingested in parts while they ran.
  Store store = Store::create(campaign_.path() / "campaign.db", {"small", "", "", 1.7e9, "0", "0"});
  store_analysis(store, campaign_.study().analysis);
  for (const int ordinal : {1, 5}) {
    const Point point = campaign_.add_point(ordinal);
    store.add_point(row_of(point), parameter_rows_of(point), "added");
    campaign_.add_attempt(point.key, 1);
    AttemptRow attempt;
    attempt.point = point.key;
    attempt.number = 1;
    attempt.token = "token1";
    attempt.started_unix_s = 1.7e9 + 1000;
    attempt.state = AttemptState::launched;
    store.put_attempt(attempt);
    store.change_state(point.key, State::waiting, State::running, "started", 1);
    for (const std::int64_t end : {20000, 70000, 100000}) {
      set_content(campaign_.log(point.key), log_header + log_lines(0, end));
      ingest_point(store, campaign_.path(), point.key);
    }
    campaign_.end_attempt(point.key, 1, 0, 0, 100000);
    ingest_point(store, campaign_.path(), point.key);
    AttemptRow ended = store.attempts(point.key).at(0);
    ended.state = AttemptState::ended;
    store.put_attempt(ended);
    store.change_state(point.key, State::running, State::done, "exit.json says 0", 1);
  }
  const Content before(store), after(rebuilt());
  EXPECT_TRUE(before.points == after.points);
  EXPECT_TRUE(before.attempts == after.attempts);
  EXPECT_TRUE(before == after);
  EXPECT_EQ(report_.points, 2);
  EXPECT_EQ(report_.samples, 2002);
  EXPECT_THAT(report_.warnings, IsEmpty());
}

TEST_F(RebuildTest, StateFollowsFromTheLastAttempt) {
  const std::string key = campaign_.add_point(1).key;
  EXPECT_EQ(state_of(key), State::waiting);
  campaign_.add_attempt(key, 1);
  set_content(campaign_.log(key), log_header + log_lines(0, 100000));
  EXPECT_EQ(state_of(key), State::crashed);
  EXPECT_EQ(state_of(key, Life::alive), State::running);
  EXPECT_EQ(state_of(key, Life::unknown), State::running);
  for (const auto& [code, state] :
       {std::pair(0, State::done), std::pair(75, State::stopped), std::pair(70, State::failed),
        std::pair(65, State::refused), std::pair(74, State::crashed)}) {
    campaign_.end_attempt(key, 1, code, 0, code == 0 ? 100000 : 1000);
    EXPECT_EQ(state_of(key), state) << code;
  }
}

TEST_F(RebuildTest, CrashesWithoutProgressUseUpTheRetries) {
  const std::string key = campaign_.add_point(1).key;
  for (int number = 1; number <= 2; ++number) campaign_.add_attempt(key, number, 500);
  campaign_.add_checkpoint(key, 500);
  EXPECT_EQ(rebuilt().point(key)->retries_used, 2);
  campaign_.add_attempt(key, 3, 500);  // the study allows two retries
  EXPECT_EQ(state_of(key), State::exhausted);
  campaign_.add_checkpoint(key, 900);
  EXPECT_EQ(state_of(key), State::crashed);
  EXPECT_EQ(rebuilt().point(key)->retries_used, 0);
}

TEST_F(RebuildTest, DecisionsOfTheUserAreKept) {
  Point point = campaign_.add_point(1);
  campaign_.add_attempt(point.key, 1);
  campaign_.end_attempt(point.key, 1, 70, 0, 1000);
  point.retried_after = 1;
  write_point(campaign_.run(point.key) / "point.json", point);
  EXPECT_EQ(state_of(point.key), State::waiting);
  campaign_.add_checkpoint(point.key, 500);
  EXPECT_EQ(state_of(point.key), State::stopped);
  point.cancelled = true;
  write_point(campaign_.run(point.key) / "point.json", point);
  EXPECT_EQ(state_of(point.key), State::cancelled);
}

TEST_F(RebuildTest, DoneRunWithALaterEndGoesOn) {
  Point point = finished_point(1);
  point.facts.steps = 200000;
  write_point(campaign_.run(point.key) / "point.json", point);
  EXPECT_EQ(state_of(point.key), State::stopped);
}

TEST_F(RebuildTest, RunWithoutAllItsSamplesIsNotDone) {
  const std::string key = finished_point(1).key;
  EXPECT_EQ(state_of(key), State::done);
  std::string damaged = content_of(campaign_.log(key));
  damaged[damaged.find("\n1000,") + 8] ^= 1;
  for (const std::string& log : {damaged, log_header + log_lines(0, 99900)}) {
    set_content(campaign_.log(key), log);
    EXPECT_EQ(state_of(key), State::refused) << "there is no checkpoint to go back to";
    campaign_.add_checkpoint(key, 100000);
    EXPECT_EQ(state_of(key), State::crashed);
    EXPECT_THAT(rebuilt().events(key).back().evidence, HasSubstr("samples.csv"));
    std::filesystem::remove(campaign_.run(key) / "checkpoints" / "000000100000.h5");
  }
}

TEST_F(RebuildTest, EventsAreReconstructedWithTheirTimes) {
  const std::string key = finished_point(1).key;
  const std::vector<EventRow> events = rebuilt().events(key);
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[1].to, State::running);
  EXPECT_EQ(events[1].unix_s, 1.7e9 + 1000);
  EXPECT_EQ(events[2].to, State::done);
  EXPECT_EQ(events[2].unix_s, 1.7e9 + 1500);
  EXPECT_THAT(events[2].evidence, HasSubstr("reconstructed"));
}

TEST_F(RebuildTest, DamagedPointIsNamedAndTheOthersAreTakenIn) {
  const std::string bad = campaign_.add_point(1).key, good = campaign_.add_point(2).key;
  set_content(campaign_.run(bad) / "point.json", "{");
  const Store store = rebuilt();
  EXPECT_EQ(store.points().size(), 1U);
  EXPECT_TRUE(store.point(good));
  EXPECT_THAT(report_.warnings, Contains(HasSubstr(bad)));
}

TEST_F(RebuildTest, WithoutItsPointsMakesNoEmptyDatabase) {
  campaign_.add_point(1);
  const std::filesystem::path points = campaign_.path() / "points", away = campaign_.path() / "away";
  std::filesystem::rename(points, away);
  EXPECT_THROW(rebuilt(), Error);
  set_content(points, "not a folder");
  EXPECT_THROW(rebuilt(), Error);
  std::filesystem::remove(points);
  std::filesystem::create_symlink("points", points);  // looking at it fails, for root too
  EXPECT_ANY_THROW(rebuilt());
  std::filesystem::remove(points);
  std::filesystem::rename(away, points);
  EXPECT_EQ(rebuilt().points().size(), 1U);
}

TEST_F(RebuildTest, CopyOfAPointIsNotTakenForAnother) {
  const std::string key = campaign_.add_point(1).key;
  std::filesystem::copy(campaign_.run(key), campaign_.path() / "points" / "copy",
                        std::filesystem::copy_options::recursive);
  EXPECT_EQ(rebuilt().points().size(), 1U);
  EXPECT_THAT(report_.warnings, Contains(HasSubstr("its point.json is that of")));
}

}  // namespace
}  // namespace rouleau::campaign
