// SPDX-License-Identifier: BSD-3-Clause
// A real Slurm whose controller is killed, or whose munge is away: no conclusion is drawn, and nothing is lost.
#include "slurm/real_campaign.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::eventually;
using rouleau::testing::RealCampaign;
using rouleau::testing::SlurmSandbox;

constexpr int engine_unreachable = 6;

struct Outage {
  const char* name;
  const char* begin;
  const char* end;
};

class RealOutage : public ::testing::TestWithParam<Outage> {};

TEST_P(RealOutage, IsWaitedOut) {
  const SlurmSandbox sandbox;
  const RealCampaign campaign("5");
  const Capture chosen =
      campaign.program.rouleau({"run", "c", "--engine", "slurm", "--cluster", "cluster.ini", "--self-sustaining"});
  ASSERT_EQ(chosen.status, 0) << chosen.err;
  ASSERT_TRUE(eventually([&] { return campaign.has_checkpoint(1); })) << chosen.err;

  sandbox.call({GetParam().begin});
  for (int pass = 0; pass < 2; ++pass) {
    const Capture silent = campaign.program.rouleau({"sync", "c"});
    EXPECT_EQ(silent.status, engine_unreachable) << silent.err;
    EXPECT_EQ(campaign.attempts(1), 1) << "something was submitted though nobody answers";
  }
  sandbox.call({GetParam().end});
  // What Slurm made of its job meanwhile (went on, started anew, held, failed: all were seen) must not matter.
  Capture last;
  const bool is_done = eventually([&] {
    last = campaign.program.rouleau({"sync", "c"});
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    return campaign.program.state(1) == State::done;
  });
  ASSERT_TRUE(is_done) << last.err << campaign.report() << run_and_capture({"squeue", "-t", "all"}).out
                       << run_and_capture({"sinfo", "-N", "-l"}).out;
  ::testing::Test::RecordProperty("attempts", campaign.attempts(1));
  expect_local_outcome(campaign, "5");
}

INSTANTIATE_TEST_SUITE_P(Of, RealOutage,
                         ::testing::Values(Outage{"TheController", "kill-controller", "start-controller"},
                                           Outage{"Munge", "kill-munge", "start-munge"}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace rouleau::campaign
