// SPDX-License-Identifier: BSD-3-Clause
// A run of 2n steps equals n steps, a stop, and n more, bit for bit: whatever the numerics, on any number of ranks.
#include <gtest/gtest.h>

#include <tuple>

#include "restart/small_run.hpp"

namespace rouleau::testing {
namespace {

constexpr int n = 25;

using Numerics = std::tuple<std::string, std::string, std::string, std::string>;

class Restart : public ::testing::TestWithParam<Numerics> {
 protected:
  [[nodiscard]] static Changes changes() {
    const auto& [precision, collision, kernel, advection] = GetParam();
    return {{"numerics.precision", precision},
            {"numerics.collision", collision},
            {"numerics.kernel", kernel},
            {"numerics.advection", advection}};
  }
};

TEST_P(Restart, EqualsAnUninterruptedRunOnAnyNumberOfRanks) {
  SmallRun whole(changes());
  whole.set_steps(2 * n);
  whole.finish();

  SmallRun parts(changes());
  parts.set_steps(n);
  parts.finish(2);
  parts.set_steps(2 * n);
  parts.finish(3);
  EXPECT_EQ(parts.exit_record().at("resumed_from"), "checkpoints/000000000025.h5");
  EXPECT_EQ(parts.fingerprint(), whole.fingerprint());
}

INSTANTIATE_TEST_SUITE_P(Numerics, Restart,
                         ::testing::Combine(::testing::Values("single", "double"), ::testing::Values("trt", "mrt"),
                                            ::testing::Values("2-point", "3-point", "4-point"),
                                            ::testing::Values("euler", "adams_bashforth", "averaged")));

TEST(Ranks, OneToSixGiveTheSameBits) {
  const SmallRun one;
  one.finish(1);
  const std::string expected = one.fingerprint();
  for (const int ranks : {2, 3, 4, 6}) {
    const SmallRun other;
    other.finish(ranks);
    EXPECT_EQ(other.fingerprint(), expected) << ranks << " ranks";
  }
}

TEST(Ranks, EveryCutGivesTheSameBits) {
  const SmallRun one;
  one.finish(1);
  const std::string expected = one.fingerprint();
  for (const char* cut : {"4x1x1", "1x4x1", "1x1x2", "2x2x1", "2x1x2"}) {
    const int ranks = (cut[0] - '0') * (cut[2] - '0') * (cut[4] - '0');
    const SmallRun other;
    const Finished finished = other.run(ranks, {"--ranks", cut});
    ASSERT_EQ(finished.code, 0) << finished.err;
    EXPECT_EQ(other.fingerprint(), expected) << cut;
  }
}

TEST(Restart, TwoCellsResumeOnOtherRanks) {
  const Changes second{{"cell.2.shape", "sphere"},     {"cell.2.radius_um", "4"},    {"cell.2.position_x_um", "7"},
                       {"cell.2.offset_y_um", "-0.5"}, {"cell.2.subdivisions", "3"}, {"cell.rotation_angle_deg", "90"}};
  SmallRun whole(second);
  whole.set_steps(2 * n);
  whole.finish();
  SmallRun parts(second);
  parts.set_steps(n);
  parts.finish(4);
  parts.set_steps(2 * n);
  parts.finish(1);
  EXPECT_EQ(parts.fingerprint(), whole.fingerprint());
  EXPECT_EQ(parts.newest_checkpoint().at("cells").size(), 2u);
}

TEST(Restart, PulledNeoHookeanCellResumesOnOtherRanks) {
  // 25 steps end in the middle of the ramp, 50 behind it.
  const Changes pulled{
      {"membrane.law", "neo_hookean"}, {"stretch.axis", "y"}, {"stretch.force_pN", "20"}, {"stretch.ramp_ms", "0.05"}};
  SmallRun whole(pulled);
  whole.set_steps(2 * n);
  whole.finish();
  SmallRun parts(pulled);
  parts.set_steps(n);
  parts.finish(3);
  parts.set_steps(2 * n);
  parts.finish(2);
  EXPECT_EQ(parts.fingerprint(), whole.fingerprint());

  SmallRun free(Changes{{"membrane.law", "neo_hookean"}});
  free.set_steps(2 * n);
  free.finish();
  EXPECT_NE(free.samples(), whole.samples());
}

TEST(Restart, ChangedIdentityParameterIsRefusedByName) {
  SmallRun run;
  run.finish();
  run.set("fluid.lambda", "6");
  run.set_steps(60);
  const Finished finished = run.run();
  EXPECT_EQ(finished.code, 65);
  EXPECT_NE(finished.err.find("fluid.lambda"), std::string::npos) << finished.err;
  EXPECT_NE(finished.err.find("6"), std::string::npos) << finished.err;
}

TEST(Restart, FreeParametersMayChange) {
  SmallRun whole;
  whole.set_steps(60);
  whole.finish();
  SmallRun parts;
  parts.set_steps(30);
  parts.finish();
  parts.set("output.checkpoints_kept", "5");
  parts.set("output.checkpoint_interval_min", "3");
  parts.set_steps(60);
  parts.finish();
  EXPECT_EQ(parts.fingerprint(), whole.fingerprint());
}

}  // namespace
}  // namespace rouleau::testing
