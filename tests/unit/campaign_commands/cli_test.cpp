// SPDX-License-Identifier: BSD-3-Clause
// The command line: help, suggestions, streams, exit codes.
#include "commands/cli.hpp"

#include <gmock/gmock.h>

#include <regex>

#include "commands/verbs.hpp"
#include "support/campaign_program.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using ::testing::AllOf;
using ::testing::HasSubstr;

struct WrongLine {
  const char* what;
  std::vector<std::string> words;
  int status;
  std::vector<std::string> parts;  ///< of the one line on stderr
};

const std::vector<WrongLine> wrong_lines = {
    {"UnknownVerb", {"sttaus"}, 2, {"no verb `sttaus`", "Did you mean `status`?", "--help"}},
    {"FarVerb", {"xylophone"}, 2, {"no verb `xylophone`"}},
    {"UnknownOption", {"run", "--quite"}, 2, {"--quite", "Did you mean `--quiet`?"}},
    {"AbbreviatedOption", {"run", "--quie"}, 2, {"--quie"}},
    {"UnknownFormat", {"plan", "--format", "jsn"}, 2, {"jsn", "Did you mean `json`?"}},
    {"OptionWithoutValue", {"plan", "--format"}, 2, {"format"}},
    {"TwoDirectories", {"run", "a", "b"}, 2, {"`b` is one word too many"}},
    {"DirectoryTwice", {"run", "a", "-C", "b"}, 2, {"twice"}},
    {"InitWithoutDirectory", {"init", "study.ini"}, 2, {"a study file and a directory", "1 words"}},
    {"InitWithoutStudy", {"init", "nowhere.ini", "c"}, 3, {"nowhere.ini", "no such study file"}},
    {"InitOfADirectory", {"init", ".", "c"}, 2, {"is a directory", "study.ini"}},
    {"RunNowhere", {"run", "nowhere"}, 3, {"nowhere", "rouleau init"}},
    {"SyncNowhere", {"sync", "nowhere"}, 3, {"nowhere", "rouleau init"}},
    {"PlanNowhere", {"plan", "nowhere"}, 3, {"nowhere"}},
    {"CancelNothing", {"cancel"}, 2, {"names no point", "rouleau cancel '#3'"}},
    {"CancelNowhere", {"cancel", "#1", "-C", "nowhere"}, 3, {"nowhere"}},
    {"RetryBoth", {"retry", "#1", "--all-failed"}, 2, {"not both"}},
    {"CalibrateNotANumber", {"plan", "--calibrate-s", "x"}, 2, {"calibrate-s"}},
};

class CommandLineError : public ::testing::TestWithParam<WrongLine> {};

TEST_P(CommandLineError, IsOneLineOnStderrWithItsCode) {
  const CampaignProgram program;
  const auto capture = program.rouleau(GetParam().words);
  EXPECT_EQ(capture.status, GetParam().status);
  EXPECT_EQ(capture.out, "");
  EXPECT_EQ(std::count(capture.err.begin(), capture.err.end(), '\n'), 1) << capture.err;
  for (const std::string& part : GetParam().parts) EXPECT_THAT(capture.err, HasSubstr(part));
}

INSTANTIATE_TEST_SUITE_P(Table, CommandLineError, ::testing::ValuesIn(wrong_lines),
                         [](const ::testing::TestParamInfo<WrongLine>& line) { return std::string(line.param.what); });

TEST(CampaignHelp, ListsEveryVerbAndExitCode) {
  const CampaignProgram program;
  const auto capture = program.rouleau({"--help"});
  EXPECT_EQ(capture.status, 0);
  EXPECT_EQ(capture.err, "");
  for (const Verb* verb : all_verbs) EXPECT_THAT(capture.out, HasSubstr(verb->summary));
  for (const char* code : {"0 ok", "2 wrong", "4 some", "5 locked", "7 damage", "130"})
    EXPECT_THAT(capture.out, HasSubstr(code));
}

TEST(CampaignHelp, OfEveryVerbBeginsWithExamples) {
  const CampaignProgram program;
  for (const Verb* verb : all_verbs) {
    const auto capture = program.rouleau({verb->name, "--help"});
    EXPECT_EQ(capture.status, 0) << verb->name;
    const std::size_t examples = capture.out.find("Examples:");
    ASSERT_NE(examples, std::string::npos) << verb->name;
    EXPECT_LT(examples, capture.out.find("Usage:")) << verb->name;
    EXPECT_THAT(capture.out, AllOf(HasSubstr(std::string("rouleau ") + verb->name), HasSubstr("--quiet")));
  }
}

TEST(CampaignHelp, ExplainsTheStudyFile) {
  const CampaignProgram program;
  const auto capture = program.rouleau({"init", "--help-study"});
  EXPECT_EQ(capture.status, 0);
  EXPECT_THAT(capture.out, AllOf(HasSubstr("[sweep]"), HasSubstr("[execution]"), HasSubstr("window_s")));
}

TEST(CampaignHelp, WithoutAnyWordIsAUsageErrorThatHelps) {
  const CampaignProgram program;
  const auto capture = program.rouleau({});
  EXPECT_EQ(capture.status, 2);
  EXPECT_THAT(capture.err, HasSubstr("Verbs"));
}

TEST(CampaignVersion, NamesEveryLibrary) {
  const CampaignProgram program;
  const auto capture = program.rouleau({"--version"});
  EXPECT_EQ(capture.status, 0);
  EXPECT_TRUE(std::regex_search(capture.out, std::regex(R"(rouleau \d+\.\d+\.\d+ \(git \S+, )"))) << capture.out;
  for (const char* name : {"compiler", "SQLite 3.", "Boost 1.", "fmt ", "nlohmann-json "}) {
    EXPECT_THAT(capture.out, HasSubstr(name));
  }
}

}  // namespace
}  // namespace rouleau::campaign
