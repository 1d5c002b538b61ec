// SPDX-License-Identifier: BSD-3-Clause
// Numbers for eyes against cases rounded by hand.
#include "report/digits.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace rouleau::campaign {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

TEST(Brackets, HoldTwoDigitsOfTheErrorBelowTheLastTwoOfTheValue) {
  EXPECT_EQ(in_brackets(0.208451, 0.040431), "0.208(40)");
  EXPECT_EQ(in_brackets(0.459941, 0.00610222), "0.4599(61)");
  EXPECT_EQ(in_brackets(0.1, 0.05), "0.100(50)");
  EXPECT_EQ(in_brackets(-0.208451, 0.040431), "-0.208(40)");
}

TEST(Brackets, RoundingMayCarryIntoTheNextDigit) {
  EXPECT_EQ(in_brackets(0.0999, 0.00996), "0.100(10)");
  EXPECT_EQ(in_brackets(0.9996, 0.0123), "1.000(12)");
  EXPECT_EQ(in_brackets(9.96, 0.996), "10.0(1.0)");
  EXPECT_EQ(in_brackets(995.4, 99.6), "1000(100)");
}

TEST(Brackets, LargeErrorsKeepTheirPoint) {
  EXPECT_EQ(in_brackets(12.3456, 1.5), "12.3(1.5)");
  EXPECT_EQ(in_brackets(1234.5, 56), "1234(56)");
  EXPECT_EQ(in_brackets(1234.5, 560), "1230(560)");
}

TEST(Brackets, AnErrorMayBeLargerThanItsValue) {
  EXPECT_EQ(in_brackets(0.02, 0.31), "0.02(31)");
  EXPECT_EQ(in_brackets(-0.002, 0.31), "0.00(31)");  // not -0.00
  EXPECT_EQ(in_brackets(0, 0.31), "0.00(31)");
}

TEST(Brackets, WithoutAnErrorThereAreNone) {
  EXPECT_EQ(in_brackets(0.208450686, std::nullopt), "0.2085");
  EXPECT_EQ(in_brackets(0.208450686, nan), "0.2085");
  EXPECT_EQ(in_brackets(0.208450686, infinity), "0.2085");
  EXPECT_EQ(in_brackets(0.208450686, -1), "0.2085");
  EXPECT_EQ(in_brackets(nan, 0.1), "nan");
}

TEST(Brackets, AConstantSeriesHasNoError) {
  EXPECT_EQ(in_brackets(0.5, 0), "0.5(0)");
  EXPECT_EQ(in_brackets(0.5, 1e-17), "0.5(0)");
  EXPECT_EQ(in_brackets(0, 0), "0(0)");
}

TEST(Brackets, VerySmallAndVeryLargeValuesHaveAPowerOfTen) {
  EXPECT_EQ(in_brackets(1.234e-7, 2e-9), "1.234(20)e-07");
  EXPECT_EQ(in_brackets(2.5e8, 1e7), "2.50(10)e+08");
}

TEST(Decimals, AreThoseOfTheErrorsTwoDigits) {
  EXPECT_EQ(decimals_of(0.2, 0.0404), 3);
  EXPECT_EQ(decimals_of(0.2, 0.00996), 3);
  EXPECT_EQ(decimals_of(1234.5, 560), -1);
  EXPECT_EQ(decimals_of(0.5, 1e-17), std::nullopt);
  EXPECT_EQ(decimals_of(0.5, nan), std::nullopt);
  EXPECT_EQ(decimals_of(0.5, std::nullopt), std::nullopt);
  EXPECT_EQ(to_decimals(-0.004, 2), "0.00");
}

TEST(ShortNumber, MeasuresHaveFourDigits) {
  EXPECT_EQ(short_number(0.0286798388), "0.02868");
  EXPECT_EQ(short_number(0.0290012345), "0.02900");  // the zeros are digits too
  EXPECT_EQ(short_number(80.6268123), "80.63");
  EXPECT_EQ(short_number(12345.678), "12346");
  EXPECT_EQ(short_number(999.9712345), "1000");
  EXPECT_EQ(short_number(1.23456789e-7), "1.235e-07");
  EXPECT_EQ(short_number(-1.0 / 3), "-0.3333");
}

TEST(ShortNumber, InputsAreKeptAsTheyAre) {
  for (const char* number : {"0", "5", "4.8125", "10.0005", "0.199882", "100000", "1e-06", "-2.5"})
    EXPECT_EQ(short_number(std::stod(number)), number);
}

}  // namespace
}  // namespace rouleau::campaign
