// SPDX-License-Identifier: BSD-3-Clause
// A rank that is lost ends all of them; none waits for it for ever.
#include <gmock/gmock.h>

#include "support/process.hpp"

namespace rouleau::testing {
namespace {

TEST(LostRank, EndsAllRanksWithItsReason) {
  std::vector<std::string> words = launcher(2);
  words.emplace_back(LOST_RANK);
  // Far longer than MPI needs to start and end; the ranks would wait for ever.
  const Finished finished = run_program(words, Interruption{.after_s = 100});
  EXPECT_EQ(finished.signal, 0) << "it hung";
  EXPECT_EQ(finished.code, 1) << finished.err;
  EXPECT_THAT(finished.err, ::testing::HasSubstr("rank 1: std::bad_alloc. All ranks end here"));
}

}  // namespace
}  // namespace rouleau::testing
