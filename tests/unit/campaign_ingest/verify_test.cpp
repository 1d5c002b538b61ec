// SPDX-License-Identifier: BSD-3-Clause
// Every kind of damage is found, and news are not taken for damage.
#include "ingest/verify.hpp"

#include <gmock/gmock.h>

#include "ingest/result_file.hpp"
#include "written_campaign.hpp"

namespace rouleau::campaign {
namespace {

using ::rouleau::testing::content_of;
using ::rouleau::testing::set_content;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::log_header;
using testing::log_lines;

auto damage(const std::string& file, const std::string& problem) {
  return AllOf(Field(&Finding::damage, true), Field(&Finding::file, HasSubstr(file)),
               Field(&Finding::problem, HasSubstr(problem)));
}

auto remark(const std::string& file, const std::string& problem) {
  return AllOf(Field(&Finding::damage, false), Field(&Finding::file, HasSubstr(file)),
               Field(&Finding::problem, HasSubstr(problem)));
}

class VerifyTest : public ::testing::Test {
 protected:
  /// A campaign of one point that is done and in order.
  VerifyTest()
      : store_(Store::create(campaign_.path() / "campaign.db", {"small", text_, digest_of(text_), 1.7e9, "0", "0"})) {
    const Point point = campaign_.add_point(1);
    store_.add_point(row_of(point), parameter_rows_of(point), "added");
    campaign_.add_attempt(key_, 1);
    campaign_.end_attempt(key_, 1, 0, 0, 100000);
    AttemptRow attempt;
    attempt.point = key_;
    attempt.number = 1;
    attempt.state = AttemptState::ended;
    attempt.pid = 4711;
    store_.put_attempt(attempt);
    set_content(campaign_.log(key_), log_header + log_lines(0, 100000));
    ingest_point(store_, campaign_.path(), key_);
    store_.change_state(key_, State::waiting, State::done, "test", 1);
    write_result_file(store_, campaign_.path(), key_);
  }
  std::vector<Finding> findings() {
    const Store reader = Store::open_reader(campaign_.path() / "campaign.db");
    std::vector<Finding> all = verify_database(reader, campaign_.path());
    for (Finding& finding : verify_point(reader, campaign_.path(), key_)) all.push_back(std::move(finding));
    return all;
  }
  void change_byte(const std::filesystem::path& file, std::size_t place) {
    std::string text = content_of(file);
    text.at(place) ^= 1;
    set_content(file, text);
  }

  testing::WrittenCampaign campaign_;
  std::string text_ = content_of(campaign_.path() / "study.ini");
  Store store_;
  std::string key_ = "000000abc001";
};

TEST_F(VerifyTest, NothingIsFoundWhereAllIsWell) { EXPECT_THAT(findings(), IsEmpty()); }

TEST_F(VerifyTest, ChangedByteInTheMiddleOfTheLogIsFound) {
  change_byte(campaign_.log(key_), content_of(campaign_.log(key_)).size() / 2);
  EXPECT_THAT(findings(), ElementsAre(damage("samples.csv", "check does not match")));
}

TEST_F(VerifyTest, ChangedSampleInTheDatabaseIsFound) {
  store_.database().execute("UPDATE sample SET d_um = d_um + 1e-15 WHERE step = 5000;");
  EXPECT_THAT(findings(), ElementsAre(damage("samples.csv", "differs from it at step 5000")));
}

TEST_F(VerifyTest, ChangedResultInTheDatabaseIsFound) {
  store_.database().execute("UPDATE result SET d_mean_um = d_mean_um + 1e-15;");
  EXPECT_THAT(findings(), ElementsAre(damage("campaign.db", "not those of its samples"), damage("result.json", "")));
}

TEST_F(VerifyTest, ChangedCopyOfTheStudyInTheDatabaseIsFound) {
  store_.database().execute("UPDATE campaign SET study_text = '[execution]' || char(10) || 'retries = 0';");
  EXPECT_THAT(findings(), ElementsAre(damage("campaign.db", "copy of the study is damaged")));
}

// The database's copy was compared with its own digest only.
TEST_F(VerifyTest, StudyFileThatIsNotTheDatabasesIsFound) {
  const std::filesystem::path file = campaign_.path() / "study.ini";
  change_byte(file, text_.find("retries = 2") + 10);
  EXPECT_THAT(findings(), ElementsAre(damage("study.ini", "not the study that the database holds")));
  std::filesystem::remove(file);
  EXPECT_THAT(findings(), ElementsAre(damage("study.ini", "is missing; `rouleau init STUDY DIR`")));
  std::filesystem::create_directory(file);
  EXPECT_THAT(findings(), ElementsAre(damage("study.ini", "study.ini")));
}

TEST_F(VerifyTest, ChangedPointInTheDatabaseIsFound) {
  store_.database().execute("UPDATE point SET end_time_s = end_time_s * 2;");
  EXPECT_THAT(findings(), ElementsAre(damage("point.json", "another point than the database")));
}

TEST_F(VerifyTest, MissingSamplesInTheDatabaseAreFound) {
  store_.database().execute("DELETE FROM sample WHERE step = 500;");
  EXPECT_THAT(findings(), ElementsAre(damage("samples.csv", "step 600")));
}

TEST_F(VerifyTest, ChangedRecordsAreFound) {
  change_byte(campaign_.run(key_) / "result.json", 30);
  campaign_.end_attempt(key_, 1, 70, 0, 100000);
  EXPECT_THAT(findings(), ElementsAre(damage("attempts/1", "something else"), damage("result.json", "")));
}

TEST_F(VerifyTest, DamagedPointFileIsFound) {
  set_content(campaign_.run(key_) / "point.json", "{");
  EXPECT_THAT(findings(), ElementsAre(damage("point.json", "is damaged")));
}

TEST_F(VerifyTest, VanishedAttemptAndLogAreFound) {
  std::filesystem::remove_all(campaign_.run(key_) / "attempts" / "1");
  EXPECT_THAT(findings(), ElementsAre(damage("attempts/1", "it is gone")));
}

TEST_F(VerifyTest, AttemptOfWhichOnlyTheIntentWasWrittenNeedsNoFolder) {
  AttemptRow attempt;
  attempt.point = key_;
  attempt.number = 2;
  attempt.state = AttemptState::ended;  // closed by the manager that came after the killed one
  store_.put_attempt(attempt);
  write_result_file(store_, campaign_.path(), key_);
  EXPECT_THAT(findings(), IsEmpty());
}

TEST_F(VerifyTest, NewsAreRemarksOnly) {
  set_content(campaign_.log(key_), log_header + log_lines(0, 100500));
  campaign_.add_attempt(key_, 2);
  std::filesystem::remove(campaign_.run(key_) / "result.json");
  std::filesystem::create_directories(campaign_.path() / "points" / "unknown");
  EXPECT_THAT(findings(),
              ElementsAre(remark("points/unknown", "does not know it"), remark("samples.csv", "5 samples are not"),
                          remark("attempts/2", "does not know this attempt"), remark("result.json", "missing")));
}

TEST_F(VerifyTest, LogOfAFinishedRunThatIsGoneOrShorterIsFound) {
  set_content(campaign_.log(key_), log_header + log_lines(0, 50000));
  EXPECT_THAT(findings(), ElementsAre(damage("samples.csv", "it has 501 samples, the database keeps 1001")));
  std::filesystem::remove(campaign_.log(key_));
  EXPECT_THAT(findings(), ElementsAre(damage("samples.csv", "it has 0 samples, the database keeps 1001")));
}

TEST_F(VerifyTest, LogThatWasCutBackIsARemark) {
  store_.change_state(key_, State::done, State::stopped, "a later end");
  set_content(campaign_.log(key_), log_header + log_lines(0, 50000));
  EXPECT_THAT(findings(), ElementsAre(remark("samples.csv", "cut back")));
}

}  // namespace
}  // namespace rouleau::campaign
