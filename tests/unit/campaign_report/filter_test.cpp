// SPDX-License-Identifier: BSD-3-Clause
// Conditions: what they select, what they refuse, and that no text of the user reaches the SQL.
#include "report/filter.hpp"

#include <gmock/gmock.h>

#include "report/phase_table.hpp"
#include "small_campaign.hpp"
#include "study/error.hpp"

namespace rouleau::campaign {
namespace {

using ::testing::HasSubstr;

class FilterTest : public ::testing::Test {
 protected:
  /// The ordinals of the points that a condition selects: "1 3".
  std::string selected(const std::string& condition) {
    std::string text;
    for (const std::vector<Value>& row : phase_table(campaign_.store, {"ordinal", condition, "ordinal", {}}).rows)
      text += exact_text(row[0]) + ' ';
    return text.substr(0, text.find_last_not_of(' ') + 1);
  }
  std::string error_of(const std::string& condition) {
    try {
      return fmt::format("selected {}", selected(condition));
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Exit::usage);
      return error.what();
    }
  }

  testing::SmallCampaign campaign_;
};

TEST_F(FilterTest, ComparisonsSelect) {
  EXPECT_EQ(selected("lambda = 4.75"), "2");
  EXPECT_EQ(selected("fluid.lambda == 4.750"), "2");
  EXPECT_EQ(selected("lambda<5"), "1 2");
  EXPECT_EQ(selected("lambda <= 5"), "1 2 3");
  EXPECT_EQ(selected("lambda>4.75"), "3 4");
  EXPECT_EQ(selected("lambda != 5"), "1 2 4");
  EXPECT_EQ(selected("lambda <> 19/4"), "1 3 4");
  EXPECT_EQ(selected("d_mean_um > 1e-1"), "2 3");
  EXPECT_EQ(selected("d_mean_um > -1"), "1 2 3");
}

TEST_F(FilterTest, RangesListsAndNull) {
  EXPECT_EQ(selected("fluid.lambda between 4 and 5 and class = slipper"), "3");
  EXPECT_EQ(selected("lambda not between 4 and 5"), "1 4");
  EXPECT_EQ(selected("lambda in (1, 10)"), "1 4");
  EXPECT_EQ(selected("state not in (done, 'waiting')"), "3");
  EXPECT_EQ(selected("d_mean_um is null"), "4");
  EXPECT_EQ(selected("class is not null"), "1 2 3");
}

TEST_F(FilterTest, AndBindsMoreThanOrAndParenthesesMoreThanBoth) {
  EXPECT_EQ(selected("lambda = 1 or lambda = 5 and state = done"), "1");
  EXPECT_EQ(selected("(lambda = 1 or lambda = 5) and state = running"), "3");
  EXPECT_EQ(selected("not (lambda = 1 or lambda = 5)"), "2 4");
  EXPECT_EQ(selected("NOT lambda = 1 AND NOT lambda = 5"), "2 4");
}

TEST_F(FilterTest, TextsAreComparedAsTexts) {
  EXPECT_EQ(selected("shape = red_blood_cell"), "1 2 3 4");
  EXPECT_EQ(selected("shape = \"sphere\""), "");
  EXPECT_EQ(selected("key = 'a1b200000002'"), "2");
}

TEST_F(FilterTest, MistakesAreNamedWithTheirPlace) {
  EXPECT_THAT(error_of("lambda"), HasSubstr("character 7: the end where a comparison"));
  EXPECT_THAT(error_of("lambda betwen 4 and 5"), HasSubstr("character 8: `betwen` where a comparison"));
  EXPECT_THAT(error_of("lambda between 4"), HasSubstr("the end where `and`"));
  EXPECT_THAT(error_of("lambda = "), HasSubstr("the end where a value"));
  EXPECT_THAT(error_of("(lambda = 4"), HasSubstr("where `)` was expected"));
  EXPECT_THAT(error_of("lambda = 4)"), HasSubstr("character 11: `)` where `and`"));
  EXPECT_THAT(error_of("lambda in 4"), HasSubstr("`(`"));
  EXPECT_THAT(error_of("= 4"), HasSubstr("the name of a column"));
  EXPECT_THAT(error_of("lambda is 4"), HasSubstr("`null`"));
  EXPECT_THAT(error_of("lambda = 'open"), HasSubstr("character 10: the quote"));
  EXPECT_THAT(error_of("lambda = 4 && lambda = 5"), HasSubstr("joined by `and`"));
}

TEST_F(FilterTest, UnknownNamesGetASuggestion) {
  EXPECT_THAT(error_of("lamda = 4"), HasSubstr("Did you mean `lambda`?"));
  EXPECT_THAT(error_of("radius_um = 4"), HasSubstr("`radius_um` may mean cell.radius_um or cell.2.radius_um"));
}

TEST_F(FilterTest, ValuesMustFitTheirColumn) {
  EXPECT_THAT(error_of("lambda = slipper"), HasSubstr("fluid.lambda is a number, `slipper` is none"));
  EXPECT_THAT(error_of("class = sliper"), HasSubstr("Did you mean `slipper`?"));
  EXPECT_THAT(error_of("state = finished"), HasSubstr("state is never `finished`"));
}

TEST_F(FilterTest, NoTextOfTheUserReachesTheSql) {
  for (const std::string attack :
       {"lambda = 1; DROP TABLE point", "lambda = 1 -- x", "lambda = 1 /* x */", "1 = 1", "'1' = '1' or 1 = 1",
        "lambda = (SELECT 1)", "p.ordinal = 1", "lambda = 1 UNION SELECT key FROM point", "\"p\".\"key\" = 'x'",
        "sqlite_version = 1", "lambda = 4) or (1 = 1", "randomblob(1000000000) = 1", "lambda like '%'", "`key` = 'x'"})
    EXPECT_THAT(error_of(attack), ::testing::Not(::testing::StartsWith("selected"))) << attack;
  EXPECT_THAT(error_of("shape = 'x'' or 1 = 1'"), ::testing::Not(::testing::StartsWith("selected")));
}

TEST_F(FilterTest, QuotedTextIsBoundNotSpliced) {
  const Columns columns(campaign_.store);
  BoundValues values;
  const std::string sql = compile_condition("shape = \"'; DROP TABLE point; --\"", columns, values);
  EXPECT_THAT(sql, ::testing::Not(HasSubstr("DROP")));
  EXPECT_EQ(std::get<std::string>(values.values().back()), "'; DROP TABLE point; --");
  EXPECT_EQ(selected("shape = \"'; DROP TABLE point; --\""), "");
  EXPECT_EQ(campaign_.store.points().size(), 4U);
}

TEST_F(FilterTest, DeepNestingIsRefusedBeforeItHurts) {
  EXPECT_THAT(error_of(std::string(100000, '(')), HasSubstr("parentheses"));
  std::string nots;
  for (int i = 0; i < 100000; ++i) nots += "not ";
  EXPECT_THAT(error_of(nots), HasSubstr("`not`"));
}

}  // namespace
}  // namespace rouleau::campaign
