// SPDX-License-Identifier: BSD-3-Clause
// A deadline counts from the solver's start: a manager gives what is left of a job, and MPI, set-up and resume take
// some.
#include <gtest/gtest.h>

#include <array>

#include "run/command_line.hpp"
#include "run/stop.hpp"

namespace rouleau::testing {
namespace {

TEST(Deadline, CountsFromTheReadingOfTheCommandLine) {
  const std::array<const char*, 4> words{"rouleau-solver", "run.ini", "--deadline-s", "100"};
  const double before = monotonic_s();
  const CommandLine line = parse_command_line(static_cast<int>(words.size()), words.data());
  ASSERT_TRUE(line.run.deadline.has_value());
  EXPECT_GE(*line.run.deadline, before + 100);
  EXPECT_LE(*line.run.deadline, monotonic_s() + 100);
}

TEST(Deadline, ThatPassedWhileTheRunWasSetUpStopsItAtOnce) {
  const Communicator comm;
  StopWatch watch(comm, monotonic_s() - 1, "no such file");
  EXPECT_EQ(watch.reason(), "deadline");
}

}  // namespace
}  // namespace rouleau::testing
