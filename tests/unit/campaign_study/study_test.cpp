// SPDX-License-Identifier: BSD-3-Clause
// Study files that are right.
#include "study/study.hpp"

#include <gmock/gmock.h>

#include "study/sweep.hpp"

namespace rouleau::campaign {
namespace {

using testing::ElementsAre;

Study study_of(const std::string& rest) { return parse_study("[study]\nname = s\n" + rest, "study.ini"); }

/// "fluid.lambda=1 cell.replica=2" for each combination.
std::vector<std::string> texts(const Study& study) {
  std::vector<std::string> all;
  for (std::size_t index = 0; index < static_cast<std::size_t>(count_of(study)); ++index) {
    const Combination combination = combination_of(study, index);
    std::string text;
    for (const Entry& entry : combination.entries) text += (text.empty() ? "" : " ") + entry.name + "=" + entry.value;
    all.push_back(text);
  }
  return all;
}

TEST(CampaignStudy, KeepsFixedParametersWithTheirLines) {
  const Study study = study_of("# comment\n[fluid]\n  lambda = 5   # five\n[cell.2]\nshape = sphere\n");
  EXPECT_EQ(study.name, "s");
  ASSERT_EQ(study.fixed.size(), 2U);
  EXPECT_EQ(study.fixed[0].name, "fluid.lambda");
  EXPECT_EQ(study.fixed[0].value, "5");
  EXPECT_EQ(study.fixed[0].line, 5);
  EXPECT_EQ(study.fixed[1].name, "cell.2.shape");
}

TEST(CampaignStudy, WithoutASweepIsOnePoint) {
  EXPECT_THAT(texts(study_of("[fluid]\nlambda = 5\n")), ElementsAre("fluid.lambda=5"));
}

TEST(CampaignStudy, MixesListsAndRanges) {
  EXPECT_THAT(texts(study_of("[sweep]\nfluid.lambda = 1, 4:5:0.5, 7\n")),
              ElementsAre("fluid.lambda=1", "fluid.lambda=4", "fluid.lambda=4.5", "fluid.lambda=5", "fluid.lambda=7"));
}

TEST(CampaignStudy, TakesWordsAndFileNamesAsValues) {
  EXPECT_THAT(texts(study_of("[sweep]\nnumerics.kernel = 2-point, 4-point\n")),
              ElementsAre("numerics.kernel=2-point", "numerics.kernel=4-point"));
  EXPECT_THAT(texts(study_of("[sweep]\ncell.mesh_file = C:a.off, b.off\n")),
              ElementsAre("cell.mesh_file=C:a.off", "cell.mesh_file=b.off"));
}

TEST(CampaignStudy, ProductRunsThroughTheLastAxisFirst) {
  EXPECT_THAT(texts(study_of("[sweep]\na.x = 1, 2\na.y = 3, 4\n")),
              ElementsAre("a.x=1 a.y=3", "a.x=1 a.y=4", "a.x=2 a.y=3", "a.x=2 a.y=4"));
}

TEST(CampaignStudy, ZipTakesTheAxesSideBySide) {
  EXPECT_THAT(texts(study_of("[sweep]\nmode = zip\na.x = 1, 2\na.y = 3, 4\n")),
              ElementsAre("a.x=1 a.y=3", "a.x=2 a.y=4"));
}

TEST(CampaignStudy, ReplicasMultiplyThePoints) {
  const Study study = study_of("[cell]\njitter_um = 0.1\n[sweep]\nmode = zip\na.x = 1, 2\nreplicas = 2\n");
  EXPECT_EQ(count_of(study), 4);
  EXPECT_THAT(texts(study),
              ElementsAre("cell.jitter_um=0.1 a.x=1 cell.replica=1", "cell.jitter_um=0.1 a.x=1 cell.replica=2",
                          "cell.jitter_um=0.1 a.x=2 cell.replica=1", "cell.jitter_um=0.1 a.x=2 cell.replica=2"));
}

TEST(CampaignStudy, ReadsExecutionAndAnalysis) {
  const Study study = study_of(
      "[execution]\nengine = local\njobs = 2\nranks = 4\nretries = 0\ncheckpoint_interval_min = 5\n"
      "[analysis]\nwindow_s = 1/4\n");
  EXPECT_EQ(study.execution.jobs, 2);
  EXPECT_EQ(study.execution.ranks, 4);
  EXPECT_EQ(study.execution.retries, 0);
  EXPECT_EQ(study.analysis.window_s, 0.25);
  // A run parameter by another road: the solver judges it like any other.
  ASSERT_EQ(study.fixed.size(), 1U);
  EXPECT_EQ(study.fixed[0].name, "output.checkpoint_interval_min");
}

TEST(CampaignStudy, EverySettingHasItsDefaultInsideItsRange) {
  const Study study = study_of("");
  for (const auto& row : execution_rows()) {
    EXPECT_GE(study.execution.*row.member, row.minimum) << row.name;
    EXPECT_LE(study.execution.*row.member, row.maximum) << row.name;
  }
  for (const auto& row : analysis_rows()) {
    EXPECT_GE(study.analysis.*row.member, row.minimum) << row.name;
    EXPECT_LE(study.analysis.*row.member, row.maximum) << row.name;
  }
}

TEST(CampaignStudy, HelpNamesEverySetting) {
  const std::string help = study_help();
  for (const auto& row : execution_rows()) EXPECT_THAT(help, testing::HasSubstr(std::string(row.name) + " "));
  for (const auto& row : analysis_rows()) EXPECT_THAT(help, testing::HasSubstr(std::string(row.name) + " "));
}

}  // namespace
}  // namespace rouleau::campaign
