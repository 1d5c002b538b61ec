// SPDX-License-Identifier: BSD-3-Clause
// Columns, order and windows of the phase table.
#include "report/phase_table.hpp"

#include <gmock/gmock.h>

#include "report/columns.hpp"
#include "small_campaign.hpp"
#include "study/error.hpp"

namespace rouleau::campaign {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> column(const Table& table, std::size_t c) {
  std::vector<std::string> texts;
  for (const std::vector<Value>& row : table.rows) texts.push_back(exact_text(row[c]));
  return texts;
}

TEST(PhaseTable, DefaultShowsWhatWasSweptAndFound) {
  testing::SmallCampaign campaign;
  const Table table = phase_table(campaign.store, {});
  EXPECT_THAT(table.columns,
              ElementsAre("ordinal", "lambda", "state", "class", "d_mean_um", "d_error_um", "d_amplitude_um",
                          "d_period_s", "asphericity_mean", "time_s", "attempts", "core_h", "mlups"));
  EXPECT_THAT(column(table, 1), ElementsAre("1", "4.75", "5", "10"));
  EXPECT_THAT(column(table, 3), ElementsAre("croissant", "undecided", "slipper", ""));
}

TEST(PhaseTable, ColumnsAndOrderAreChosen) {
  testing::SmallCampaign campaign;
  const Table table =
      phase_table(campaign.store, {"lambda, cell.2.radius_um", "class is not null", "state,-lambda", {}});
  EXPECT_THAT(table.columns, ElementsAre("lambda", "cell.2.radius_um"));
  EXPECT_THAT(column(table, 0), ElementsAre("4.75", "1", "5"));
  EXPECT_THROW(phase_table(campaign.store, {"lambda,,state", "", "", {}}), Error);
  EXPECT_THROW(phase_table(campaign.store, {"lambda", "", "-", {}}), Error);
}

TEST(PhaseTable, AnotherWindowIsComputedFromTheSamplesByAReader) {
  testing::SmallCampaign campaign;
  std::vector<SampleRow> samples;
  for (int i = 0; i <= 1000; ++i) {
    SampleRow sample;
    sample.step = 10 * i;
    sample.time_s = 1e-3 * i;
    sample.d_um = i > 900 ? 1.0 : 0.0;
    sample.asphericity = 0.1;
    samples.push_back(sample);
  }
  campaign.store.put_samples("c3d400000004", samples);
  Store reader = Store::open_reader(campaign.directory.path() / "campaign.db");
  Analysis analysis;
  analysis.window_s = 0.2;
  const PhaseQuery wide{"ordinal,d_mean_um,samples", "d_mean_um is not null", "", analysis};
  EXPECT_THAT(phase_table(reader, wide).rows,
              ElementsAre(ElementsAre(Value(std::int64_t{4}), Value(0.5), Value(std::int64_t{200}))));
  analysis.window_s = 0.1;
  const PhaseQuery narrow{"ordinal,d_mean_um,samples", "d_mean_um is not null", "", analysis};
  EXPECT_THAT(phase_table(reader, narrow).rows,
              ElementsAre(ElementsAre(Value(std::int64_t{4}), Value(1.0), Value(std::int64_t{100}))));
  EXPECT_THAT(column(phase_table(reader, {"d_mean_um", "lambda = 5", "", {}}), 0),
              ElementsAre("0.8"));  // the stored one
}

TEST(PhaseTableForEyes, HasTheErrorInBracketsBehindItsValue) {
  testing::SmallCampaign campaign;
  const Table table = phase_table_for_eyes(campaign.store, {"lambda,d_mean_um,class", "", "", {}});
  EXPECT_THAT(table.columns, ElementsAre("lambda", "d_mean_um", "class"));
  EXPECT_THAT(column(table, 1), ElementsAre("0.050(12)", "0.400(12)", "0.8", ""));
  EXPECT_EQ(table.right_aligned.count(1), 1U);
  EXPECT_THAT(phase_table_for_eyes(campaign.store, {}).columns, ::testing::Not(::testing::Contains("d_error_um")));
}

TEST(PhaseTableForEyes, SetsTheErrorApartWhenItIsNamed) {
  testing::SmallCampaign campaign;
  const Table table = phase_table_for_eyes(campaign.store, {"d_error_um,d_mean_um", "", "", {}});
  EXPECT_THAT(column(table, 0), ElementsAre("0.012", "0.012", "", ""));
  EXPECT_THAT(column(table, 1), ElementsAre("0.050", "0.400", "0.8", ""));
}

TEST(PhaseTableForEyes, NamingAColumnTwiceShowsItTwice) {
  testing::SmallCampaign campaign;
  const Table table = phase_table_for_eyes(campaign.store, {"d_mean_um,d_mean_um", "lambda = 1", "", {}});
  EXPECT_THAT(table.rows, ElementsAre(ElementsAre(Value(std::string("0.050(12)")), Value(std::string("0.050(12)")))));
}

TEST(PhaseTable, EveryMeasureNamesAnErrorThatIsAColumn) {
  testing::SmallCampaign campaign;
  const Columns columns(campaign.store);
  int measures = 0;
  for (const Column& one : columns.all()) {
    if (one.error.empty()) continue;
    EXPECT_EQ(columns.find(one.error).name, one.error);
    ++measures;
  }
  EXPECT_EQ(measures, 3);
}

TEST(PhaseTable, EveryListedColumnCanBeQueriedByItsNames) {
  testing::SmallCampaign campaign;
  const Columns columns(campaign.store);
  for (const Column& one : columns.all()) {
    EXPECT_EQ(phase_table(campaign.store, {one.name, "", "", {}}).rows.size(), 4U) << one.name;
    EXPECT_EQ(columns.find(columns.short_name(one)).name, one.name);
  }
}

}  // namespace
}  // namespace rouleau::campaign
