// SPDX-License-Identifier: BSD-3-Clause
// The ways to name a point.
#include "report/find_points.hpp"

#include <gmock/gmock.h>

#include "small_campaign.hpp"
#include "study/error.hpp"

namespace rouleau::campaign {
namespace {

using ::testing::HasSubstr;

class FindPointsTest : public ::testing::Test {
 protected:
  std::string found(const std::string& word) {
    std::string text;
    for (const PointRow& point : find_points(campaign_.store, word)) text += fmt::format("#{}", point.ordinal);
    return text;
  }
  std::pair<Exit, std::string> error_of(const std::string& word) {
    try {
      return {Exit::ok, "found " + found(word)};
    } catch (const Error& error) {
      return {error.code(), error.what()};
    }
  }

  testing::SmallCampaign campaign_;
};

TEST_F(FindPointsTest, KeyBeginningOrdinalAndValues) {
  EXPECT_EQ(found("c3d400000003"), "#3");
  EXPECT_EQ(found("a1b200000002"), "#2");
  EXPECT_EQ(found("#4"), "#4");
  EXPECT_EQ(found("lambda=5"), "#3");
  EXPECT_EQ(found("lambda=4.750"), "#2");
  EXPECT_EQ(found("fluid.lambda = 19/4"), "#2");
  EXPECT_EQ(found("shape=red_blood_cell"), "#1#2#3#4");
  EXPECT_EQ(found("shape=red_blood_cell,lambda=10"), "#4");
  EXPECT_EQ(found("state=done"), "#1#2");
}

TEST_F(FindPointsTest, MissesAndAmbiguitiesAreErrors) {
  EXPECT_EQ(error_of("ffff").first, Exit::not_found);
  EXPECT_EQ(error_of("#9").first, Exit::not_found);
  EXPECT_EQ(error_of("lambda=3").first, Exit::not_found);
  EXPECT_EQ(error_of("").first, Exit::not_found);
  EXPECT_THAT(error_of("a1b2").second, HasSubstr("beginning of 2 keys"));
  EXPECT_EQ(error_of("#x").first, Exit::usage);
  EXPECT_THAT(error_of("lamda=5").second, HasSubstr("Did you mean `lambda`?"));
  EXPECT_THAT(error_of("lambda=five").second, HasSubstr("`five` is none"));
  EXPECT_THAT(error_of("class=slipper").second, HasSubstr("is a result"));
  EXPECT_THAT(error_of("shape=x' OR '1'='1").first, Exit::not_found);
}

}  // namespace
}  // namespace rouleau::campaign
