// SPDX-License-Identifier: BSD-3-Clause
// The verbs that read, and rebuild, as a user calls them: words in, streams and exit code out.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "three_points.hpp"

namespace rouleau::campaign {
namespace {

using ::rouleau::testing::content_of;
using ::rouleau::testing::set_content;
using testing::Answer;
using testing::call;
using ::testing::HasSubstr;
using Json = nlohmann::json;

class VerbsTest : public ::testing::Test {
 protected:
  Answer on_campaign(std::vector<std::string> words) const {
    words.insert(words.end(), {"--dir", campaign_.path()});
    return call(words);
  }

  testing::ThreePoints campaign_;
};

TEST_F(VerbsTest, RebuildMakesTheDatabaseAndKeepsTheOldFile) {
  EXPECT_EQ(campaign_.made.code, 0) << campaign_.made.err;
  EXPECT_THAT(campaign_.made.err, HasSubstr("3 points, 2 attempts, 2002 samples"));
  const std::string before = on_campaign({"export"}).out;
  set_content(campaign_.path() / "campaign.db", "not a database any more");
  EXPECT_EQ(on_campaign({"query"}).code, 7);
  EXPECT_EQ(on_campaign({"rebuild"}).code, 0);
  EXPECT_EQ(on_campaign({"export"}).out, before);
  EXPECT_EQ(content_of(campaign_.path() / "campaign.db.before-rebuild"), "not a database any more");
}

TEST_F(VerbsTest, RebuildAgainKeepsWhatTheFirstHasKept) {
  const std::filesystem::path database = campaign_.path() / "campaign.db";
  for (const char* old : {"first", "second", "third"}) {
    set_content(database, old);
    EXPECT_EQ(on_campaign({"rebuild"}).code, 0);
  }
  for (const auto& [name, old] : {std::pair("", "first"), std::pair("-2", "second"), std::pair("-3", "third")})
    EXPECT_EQ(content_of(database.string() + ".before-rebuild" + name), old);
  std::filesystem::remove(database);
  EXPECT_THAT(on_campaign({"rebuild"}).err, ::testing::Not(HasSubstr("the old file")));
}

TEST_F(VerbsTest, RebuildThatIsRefusedLeavesEverythingAsItWas) {
  const std::string before = content_of(campaign_.path() / "campaign.db");
  std::filesystem::rename(campaign_.path() / "points", campaign_.path() / "elsewhere");
  EXPECT_EQ(on_campaign({"rebuild"}).code, 3);
  EXPECT_EQ(content_of(campaign_.path() / "campaign.db"), before);
  for (const char* beside : {"campaign.db.tmp", "campaign.db.tmp-journal", "campaign.db.before-rebuild"})
    EXPECT_FALSE(std::filesystem::exists(campaign_.path() / beside)) << beside;
}

TEST_F(VerbsTest, RebuildNamesDamagedFilesAndEndsWith7) {
  set_content(campaign_.run("000000abc009") / "point.json", "{");
  const Answer answer = on_campaign({"rebuild"});
  EXPECT_EQ(answer.code, 7);
  EXPECT_THAT(answer.err, HasSubstr("000000abc009/point.json"));
}

TEST_F(VerbsTest, StatusShowsEveryPoint) {
  const Answer answer = on_campaign({"status"});
  EXPECT_EQ(answer.code, 0);
  EXPECT_THAT(answer.out, HasSubstr("#5"));
  EXPECT_THAT(answer.out, HasSubstr("crashed"));
  EXPECT_THAT(answer.err, HasSubstr("small: 3 points: 1 waiting, 1 done, 1 crashed"));
  const Json json = Json::parse(on_campaign({"status", "--format", "json"}).out);
  EXPECT_EQ(json["rows"].size(), 3U);
  EXPECT_EQ(json["rows"][0]["fraction"], 1.0);
  EXPECT_EQ(json["rows"][0]["lambda"], 1.0);
}

TEST_F(VerbsTest, StatusReadsTheProgressOfARun) {
  set_content(campaign_.run("000000abc005") / "progress.json",
              R"({"contract": 1, "attempt": 1, "step": 25000, "end_step": 100000, "d_um": 0.81, "asphericity": 0.12})");
  const Json json = Json::parse(on_campaign({"status", "--format", "json"}).out);
  EXPECT_EQ(json["rows"][1]["step"], 25000);
  EXPECT_EQ(json["rows"][1]["d_um"], 0.81);
}

TEST_F(VerbsTest, StatusEndsWith4OnFailuresOnlyWhenAskedTo) {
  campaign_.end_attempt("000000abc005", 1, 70, 0, 5000);
  on_campaign({"rebuild"});
  EXPECT_EQ(on_campaign({"status"}).code, 0);
  EXPECT_EQ(on_campaign({"status", "--exit-code"}).code, 4);
}

TEST_F(VerbsTest, DamagedProgressDoesNotBreakStatus) {
  set_content(campaign_.run("000000abc005") / "progress.json", "{");
  const Answer answer = on_campaign({"status"});
  EXPECT_EQ(answer.code, 0);
  EXPECT_THAT(answer.out, HasSubstr("progress.json: is damaged"));
}

TEST_F(VerbsTest, ShowTellsEverythingAboutAPoint) {
  const Answer answer = on_campaign({"show", "lambda=1"});
  EXPECT_EQ(answer.code, 0);
  for (const char* part : {"fluid.lambda", "result of cell 0", "slipper", "attempt 1", "resumed_from"})
    EXPECT_THAT(answer.out, HasSubstr(part));
  EXPECT_EQ(Json::parse(on_campaign({"show", "#1", "--format", "json"}).out)["kind"], "point");
  EXPECT_EQ(on_campaign({"show", "#77"}).code, 3);
}

TEST_F(VerbsTest, WhyListsTheEvidence) {
  const Answer answer = on_campaign({"why", "#1"});
  EXPECT_THAT(answer.out, HasSubstr("exit.json says 0"));
  EXPECT_THAT(answer.out, HasSubstr("2023-11-14T22:30:00Z"));  // started_unix_s of attempt 1
}

TEST_F(VerbsTest, QueryPrintsThePhaseTable) {
  const Answer answer = on_campaign({"query"});
  EXPECT_EQ(answer.code, 0);
  EXPECT_THAT(answer.out, HasSubstr("slipper"));
  EXPECT_EQ(on_campaign({"query", "--columns", "lambda,class", "--where", "class = slipper", "--sort", "-lambda",
                         "--format", "csv", "--no-header"})
                .out,
            "5,slipper\r\n1,slipper\r\n");
}

TEST_F(VerbsTest, QueryOverAnotherWindowSimulatesNothing) {
  const auto mean = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"query", "--columns", "d_mean_um", "--where", "lambda = 1", "--format", "json"});
    return Json::parse(on_campaign(options).out)["rows"][0]["d_mean_um"].get<double>();
  };
  EXPECT_NEAR(mean({"--window", "0.2"}), 0.9, 1e-3);  // a whole period
  EXPECT_LT(mean({}), 0.85);                          // the study's 0.1 s: the lower half wave
}

TEST_F(VerbsTest, QueryShowsErrorsInBracketsToEyesAndEveryDigitToPrograms) {
  const std::vector<std::string> words = {"query", "--columns", "lambda,d_mean_um", "--where", "lambda = 1"};
  EXPECT_THAT(on_campaign(words).out, ::testing::MatchesRegex("lambda +d_mean_um\n +1  [0-9.]+\\([0-9]+\\)\n"));
  std::vector<std::string> exact = words;
  exact.insert(exact.end(), {"--format", "csv"});
  EXPECT_THAT(on_campaign(exact).out, ::testing::MatchesRegex("lambda,d_mean_um\r\n1,0\\.[0-9]{12,}\r\n"));
}

TEST_F(VerbsTest, QueryNamesTheColumnsThatATerminalHasNoRoomFor) {
  std::ostringstream out, err;
  Streams io{out, err, true, true, false, 80};
  EXPECT_EQ(run_command_line(all_verbs, {"query", campaign_.path()}, io), 0);
  std::istringstream lines(out.str());
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
  EXPECT_THAT(out.str(), HasSubstr("d_mean_um"));
  EXPECT_THAT(err.str(), HasSubstr("80 columns have no room for"));
  EXPECT_THAT(err.str(), HasSubstr("core_h, mlups; `--columns` chooses"));
  EXPECT_THAT(on_campaign({"query"}).out, HasSubstr("mlups"));  // a file or a pipe has room
}

TEST_F(VerbsTest, QueryWithoutAMatchEndsWith3AndWithAMistakeWith2) {
  EXPECT_EQ(on_campaign({"query", "--where", "lambda > 100"}).code, 3);
  const Answer answer = on_campaign({"query", "--where", "lamda > 100"});
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.err, HasSubstr("Did you mean `lambda`?"));
  EXPECT_EQ(on_campaign({"query", "--window", "-1"}).code, 2);
  EXPECT_EQ(on_campaign({"query", "--analysis", "slipper_d_um=0.1"}).code, 2);  // below croissant_d_um
  EXPECT_EQ(on_campaign({"query", "--list-columns"}).code, 0);
}

TEST_F(VerbsTest, VerifyEndsWith7OnDamageOnly) {
  Answer answer = on_campaign({"verify"});
  EXPECT_EQ(answer.code, 0) << answer.out;  // the missing result.json of point 1 is a remark
  EXPECT_THAT(answer.err, HasSubstr("3 points verified: 0 damaged, 1 remarks"));
  std::string log = content_of(campaign_.log("000000abc005"));
  log[log.size() / 2] ^= 1;
  set_content(campaign_.log("000000abc005"), log);
  answer = on_campaign({"verify", "--format", "json"});
  EXPECT_EQ(answer.code, 7);
  EXPECT_THAT(answer.out, HasSubstr("samples.csv"));
}

TEST_F(VerbsTest, DirectoryWithoutACampaignIsNamedWithTheRemedy) {
  for (const char* verb : {"status", "query", "export", "verify", "rebuild"}) {
    const Answer answer = call({verb, campaign_.path() / "points"});
    EXPECT_EQ(answer.code, 3) << verb;
    EXPECT_THAT(answer.err, HasSubstr("rouleau init")) << verb;
  }
}

}  // namespace
}  // namespace rouleau::campaign
