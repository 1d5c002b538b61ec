// SPDX-License-Identifier: BSD-3-Clause
// Numbers and ranges of study files.
#include "study/numbers.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace rouleau::campaign {
namespace {

using testing::ElementsAre;

TEST(CampaignNumbers, AreDecimalsAndFractions) {
  EXPECT_EQ(parse_number("4.75"), 4.75);
  EXPECT_EQ(parse_number("+1e-3"), 1e-3);
  EXPECT_EQ(parse_number("1/3"), 1.0 / 3.0);
  for (const char* wrong : {"", "x", "4 5", "1/0", "1/", "inf", "nan", "0x10", "1,5"}) {
    EXPECT_FALSE(parse_number(wrong).has_value()) << wrong;
  }
}

TEST(CampaignNumbers, ShortestTextReadsBackToTheSameBits) {
  for (const double value : {0.1, 1.0 / 3.0, 4.75, 1e-300, 123456789.123456789}) {
    EXPECT_EQ(parse_number(shortest(value)), value);
  }
}

TEST(CampaignRange, IncludesItsEnd) {
  EXPECT_THAT(expand_range("4", "5", "0.25"), ElementsAre("4", "4.25", "4.5", "4.75", "5"));
  EXPECT_THAT(expand_range("5", "4", "-0.5"), ElementsAre("5", "4.5", "4"));
  EXPECT_THAT(expand_range("2", "2", "1"), ElementsAre("2"));
  EXPECT_THAT(expand_range("0", "1", "0.4"), ElementsAre("0", "0.4", "0.8"));
}

TEST(CampaignRange, HoldsTheDecimalsThatAPersonWouldWrite) {
  // A running sum of 0.1 misses 0.3 by one bit at its third value, and 0.8 at its eighth.
  const std::vector<std::string> values = expand_range("0", "100", "0.1");
  ASSERT_EQ(values.size(), 1001U);
  for (int i = 0; i <= 1000; ++i) {
    const std::string written = std::to_string(i / 10) + "." + std::to_string(i % 10);
    EXPECT_EQ(parse_number(values[static_cast<std::size_t>(i)]), parse_number(written)) << written;
  }
}

TEST(CampaignRange, TakesFractions) {
  const std::vector<std::string> values = expand_range("1/3", "1", "1/3");
  ASSERT_EQ(values.size(), 3U);
  EXPECT_EQ(parse_number(values[0]), 1.0 / 3.0);
  EXPECT_EQ(parse_number(values[2]), 1.0);
}

TEST(CampaignRange, RefusesWhatHasNoEnd) {
  EXPECT_THROW(expand_range("1", "2", "0"), std::invalid_argument);
  EXPECT_THROW(expand_range("1", "2", "-0.1"), std::invalid_argument);
  EXPECT_THROW(expand_range("0", "1", "1e-9"), std::invalid_argument);
  EXPECT_THROW(expand_range("a", "1", "1"), std::invalid_argument);
}

}  // namespace
}  // namespace rouleau::campaign
