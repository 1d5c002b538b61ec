// SPDX-License-Identifier: BSD-3-Clause
// What may follow on a command line, by the tables of --help and the campaign that the line names.
#include "commands/completion.hpp"

#include <gmock/gmock.h>

#include "commands/verbs.hpp"
#include "support/campaign_program.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

class CompletionTest : public ::testing::Test {
 protected:
  CompletionTest() {
    program_.write_study("fluid.lambda = 1, 10, 5\nfluid.plasma_viscosity_mPa_s = 1, 2");
    const Capture made = program_.init();
    EXPECT_EQ(made.status, 0) << made.err;
  }
  static std::vector<std::string> after(const std::vector<std::string>& words) {
    std::vector<std::string> texts;
    for (const Candidate& candidate : completions(all_verbs, words)) texts.push_back(candidate.text);
    return texts;
  }
  [[nodiscard]] std::string directory() const { return program_.campaign().string(); }

 private:
  CampaignProgram program_;
};

TEST_F(CompletionTest, OfTheFirstWordIsAVerb) {
  EXPECT_THAT(after({""}), SizeIs(all_verbs.size()));
  EXPECT_THAT(after({"stat"}), ElementsAre("status"));
  EXPECT_THAT(after({"--ver"}), ElementsAre("--version"));
  EXPECT_THAT(after({"xylophone", ""}), IsEmpty());
  EXPECT_THAT(after({}), IsEmpty());
}

TEST_F(CompletionTest, OfAnOptionIsOneOfItsVerb) {
  EXPECT_THAT(after({"init", "--y"}), ElementsAre("--yes"));
  EXPECT_THAT(after({"run", "--"}), Contains("--engine"));
  EXPECT_THAT(after({"status", "--"}), Not(Contains("--engine")));
}

TEST_F(CompletionTest, OfAnOptionsValueIsWhatItsHelpNames) {
  EXPECT_THAT(after({"query", "--format", ""}), ElementsAre("table", "csv", "json"));
  EXPECT_THAT(after({"query", "--format=c"}), ElementsAre("--format=csv"));
  EXPECT_THAT(after({"run", "--engine", "s"}), ElementsAre("slurm"));
  EXPECT_THAT(after({"run", "--cluster", ""}), ElementsAre(any_file));
  EXPECT_THAT(after({"status", "-C", ""}), ElementsAre(any_directory));
  EXPECT_THAT(after({"plan", "--calibrate-s", ""}), IsEmpty());
  EXPECT_THAT(after({"query", "--analysis", "sl"}), ElementsAre("slipper_d_um="));
}

TEST_F(CompletionTest, OfAVerbsWordIsWhatItsUsageNames) {
  EXPECT_THAT(after({"engine", ""}), ElementsAre("list", "check"));
  EXPECT_THAT(after({"init", ""}), ElementsAre(any_file, any_directory));
  EXPECT_THAT(after({"run", ""}), ElementsAre(any_directory));
  EXPECT_THAT(after({"run", directory(), ""}), IsEmpty());
}

TEST_F(CompletionTest, OfAPointIsOneOfTheCampaign) {
  EXPECT_THAT(after({"show", "-C", directory(), "#"}), ElementsAre("#1", "#2", "#3", "#4", "#5", "#6"));
  EXPECT_THAT(after({"show", "-C", directory(), "lambda="}), ElementsAre("lambda=1", "lambda=5", "lambda=10"));
  EXPECT_THAT(after({"show", "--dir=" + directory(), "lambda=5,plas"}),
              ElementsAre("lambda=5,plasma_viscosity_mPa_s="));
  EXPECT_THAT(after({"show", "-C", "nowhere", ""}), IsEmpty());
}

TEST_F(CompletionTest, OfAColumnIsOneOfTheCampaignBehindTheLastComma) {
  EXPECT_THAT(after({"query", directory(), "--columns", "lambda,asphericity_m"}),
              ElementsAre("lambda,asphericity_mean"));
  EXPECT_THAT(after({"query", directory(), "--sort", "-lam"}), ElementsAre("-lambda"));
  EXPECT_THAT(after({"query", directory(), "--where", "class="}),
              ElementsAre("class=croissant", "class=slipper", "class=undecided"));
}

}  // namespace
}  // namespace rouleau::campaign
