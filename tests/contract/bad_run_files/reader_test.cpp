// SPDX-License-Identifier: BSD-3-Clause
// Each wrong run file is refused by the library with its line and its words.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "contract/bad_run_files/bad_run_files.hpp"
#include "run/feasibility.hpp"

namespace rouleau::test {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

void examine(const std::string& text) {
  const RunFile run = parse_run_file(text, "run.ini");
  const Units units(run.parameters);
  check_feasibility(run, lattice_parameters(run, units), units);
}

TEST(GoodRunFile, IsAccepted) { EXPECT_NO_THROW(examine(text_of({"", {}, 0, {}}))); }

class BadRunFileTest : public testing::TestWithParam<BadRunFile> {};

TEST_P(BadRunFileTest, IsRefusedWithLineAndReason) {
  const BadRunFile& bad = GetParam();
  if (bad.needs_mesh) {
    EXPECT_NO_THROW(examine(text_of(bad)));  // nothing but the mesh is wrong
    return;
  }
  try {
    examine(text_of(bad));
    FAIL() << "was accepted";
  } catch (const Error& e) {
    const std::string message = e.what();
    EXPECT_EQ(e.code(), Exit::bad_input) << message;
    EXPECT_THAT(message, StartsWith("run.ini:" + std::to_string(bad.line) + ": "));
    for (const auto& part : bad.parts) EXPECT_THAT(message, HasSubstr(part));
    EXPECT_THAT(message, Not(HasSubstr("\n")));
  }
}

INSTANTIATE_TEST_SUITE_P(Table, BadRunFileTest, testing::ValuesIn(bad_run_files()),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace rouleau::test
