// SPDX-License-Identifier: BSD-3-Clause
// Numbers as text.
#include "run/value_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace rouleau {
namespace {

TEST(CanonicalNumber, IsTheSameForAllWaysOfWritingIt) {
  for (const char* text : {"4.75", "4.750", "+4.75", " 4.75 ", "475e-2", "19/4"})
    EXPECT_EQ(canonical(parse_real(text)), "4.75");
  EXPECT_EQ(canonical(parse_real("1/3")), "0.3333333333333333");
  EXPECT_EQ(canonical(parse_real("3e-19")), "3e-19");
  EXPECT_EQ(canonical(parse_real("-0")), "0");
  EXPECT_EQ(canonical(parse_vector("0 1.0\t2/4")), "0 1 0.5");
}

TEST(CanonicalNumber, ReadsBackToTheSameBits) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-300, 300);
  for (int i = 0; i < 2000; ++i) {
    const double value = mantissa(random) * std::pow(10.0, exponent(random));
    EXPECT_EQ(parse_real(canonical(value)), value);
  }
}

TEST(ParsedNumber, RefusesWhatIsNone) {
  for (const char* text :
       {"", " ", "five", "1 2", "1e", "0x10", "1,5", "1/0", "1/", "/2", "nan", "-inf", "1e999", "--1", "+-1"})
    EXPECT_THROW(parse_real(text), std::invalid_argument) << text;
  for (const char* text : {"", "1.0", "1e3", "1/2", "ten", "9223372036854775808"})
    EXPECT_THROW(parse_integer(text), std::invalid_argument) << text;
  for (const char* text : {"", "1 2", "1 2 3 4", "1,2,3", "a b c"})
    EXPECT_THROW(parse_vector(text), std::invalid_argument) << text;
}

TEST(ParsedInteger, KeepsAllDigits) { EXPECT_EQ(parse_integer("9223372036854775807"), 9223372036854775807); }

TEST(NearestName, FindsSlipsOfThePenAndNothingElse) {
  const std::vector<std::string> names{"lambda", "plasma_viscosity_mPa_s", "end_time_s"};
  EXPECT_EQ(nearest("lamda", names), "lambda");
  EXPECT_EQ(nearest("plasma_viscosity_mpa_s", names), "plasma_viscosity_mPa_s");
  EXPECT_EQ(nearest("end_time", names), "end_time_s");
  EXPECT_EQ(nearest("colour", names), "");
}

}  // namespace
}  // namespace rouleau
