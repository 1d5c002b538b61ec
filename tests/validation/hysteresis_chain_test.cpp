// SPDX-License-Identifier: BSD-3-Clause
// studies/hysteresis/chain.sh: every point starts from the cell that its neighbour ended with, and a second call goes
// on where the first one was.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "support/campaign_program.hpp"

namespace rouleau::testing {
namespace {

class Chain : public ::testing::Test {
 protected:
  Chain() {
    ::setenv("ROULEAU", ROULEAU_PROGRAM, 1);
    set_content(program.path() / "start.h5", "a croissant");
  }

  /// chain.sh over that branch of lambda; `start`: the checkpoint it begins with.
  rouleau::campaign::Capture chain(const std::string& branch, const std::string& start = "start.h5") const {
    program.write_study("mode = zip\nfluid.lambda = " + branch + "\ncell.mesh_file = 0.h5\n",
                        "[cell]\nshape = checkpoint\n" + CampaignProgram::execution());
    return rouleau::campaign::run_and_capture({"bash", CHAIN, "study.ini", "c", start}, program.path());
  }
  std::filesystem::path kept(int k) const { return program.path() / "c.starts" / (std::to_string(k) + ".h5"); }
  std::string last_checkpoint(int ordinal) const {
    std::filesystem::path last;
    for (const auto& entry : std::filesystem::directory_iterator(program.run_directory(ordinal) / "checkpoints"))
      last = std::max(last, entry.path());
    return content_of(last);
  }

  CampaignProgram program;
};

TEST_F(Chain, StartsEveryPointFromItsNeighboursLastCell) {
  const auto made = chain("1, 2, 3");
  ASSERT_EQ(made.status, 0) << made.err;
  ASSERT_EQ(program.store().points().size(), 3U);
  EXPECT_EQ(content_of(kept(0)), "a croissant");
  for (int ordinal = 1; ordinal <= 3; ++ordinal) {
    EXPECT_EQ(content_of(kept(ordinal)), last_checkpoint(ordinal));
    EXPECT_NE(content_of(program.run_directory(ordinal) / "run.ini").find(std::to_string(ordinal - 1) + ".h5"),
              std::string::npos);
  }
}

TEST_F(Chain, GoesOnWhereItWas) {
  ASSERT_EQ(chain("1, 2").status, 0);
  const auto again = chain("1, 2, 3");
  ASSERT_EQ(again.status, 0) << again.err;
  ASSERT_EQ(program.store().points().size(), 3U);
  for (int ordinal = 1; ordinal <= 3; ++ordinal)
    EXPECT_EQ(program.store().attempts(program.point(ordinal).key).size(), 1U);
}

TEST_F(Chain, RefusesAnotherStart) {
  ASSERT_EQ(chain("1").status, 0);
  set_content(program.path() / "other.h5", "a slipper");
  const auto refused = chain("1", "other.h5");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("another DIR"), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace rouleau::testing
