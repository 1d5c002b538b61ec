// SPDX-License-Identifier: BSD-3-Clause
// Finding and asking the solver.
#include "executor/solver.hpp"

#include <gmock/gmock.h>

#include "study/error.hpp"
#include "support/campaign_program.hpp"

namespace rouleau::campaign {
namespace {

using ::testing::HasSubstr;

constexpr const char* good = "[channel]\nlength_x_um = 20\n[numerics]\ntime_step_us = 100\n[time]\nend_time_s = 0.01\n";

TEST(CampaignSolver, EnvironmentComesFirstAndMustBeAProgram) {
  ::setenv("ROULEAU_SOLVER", FAKE_SOLVER_PROGRAM, 1);
  EXPECT_EQ(find_solver(), FAKE_SOLVER_PROGRAM);
  ::setenv("ROULEAU_SOLVER", "/etc/passwd", 1);
  EXPECT_THROW(static_cast<void>(find_solver()), Error);
  ::unsetenv("ROULEAU_SOLVER");
}

TEST(CampaignSolver, IsFoundOnThePath) {
  const rouleau::testing::TemporaryDirectory place;
  std::filesystem::create_symlink(FAKE_SOLVER_PROGRAM, place.path() / "rouleau-solver");
  const std::string before = ::getenv("PATH");
  ::unsetenv("ROULEAU_SOLVER");
  ::setenv("PATH", ("/nowhere:" + place.path().string()).c_str(), 1);
  EXPECT_EQ(find_solver(), place.path() / "rouleau-solver");
  ::setenv("PATH", before.c_str(), 1);
}

TEST(CampaignSolver, CheckAnswersAboutAGoodRunFile) {
  const CheckOutcome outcome = solver_checker(FAKE_SOLVER_PROGRAM)(good);
  EXPECT_EQ(outcome.error, "");
  EXPECT_EQ(outcome.reply.facts.steps, 100);
}

TEST(CampaignSolver, RefusalIsRelayed) {
  const CheckOutcome outcome = solver_checker(FAKE_SOLVER_PROGRAM)(std::string(good) + "[fluid]\nlambda = 1000\n");
  EXPECT_THAT(outcome.error, HasSubstr("run.ini:8: fluid.lambda = 1000 is out of range"));
}

TEST(CampaignSolver, ProgramThatIsNoSolverIsAnErrorNotARefusal) {
  EXPECT_THROW(static_cast<void>(solver_checker("/bin/false")(good)), Error);
  EXPECT_THROW(static_cast<void>(solver_checker("/bin/echo")(good)), Error);
  EXPECT_THROW(static_cast<void>(solver_checker("/nowhere/solver")(good)), Error);
}

TEST(CampaignCapture, TakesBothStreamsAndTheStatus) {
  const Capture capture = run_and_capture({"sh", "-c", "echo out; echo err >&2; exit 7"});
  EXPECT_EQ(capture.out, "out\n");
  EXPECT_EQ(capture.err, "err\n");
  EXPECT_EQ(capture.status, 7);
}

TEST(CampaignCapture, LongOutputDoesNotBlock) {
  const Capture capture = run_and_capture({"sh", "-c", "head -c 300000 /dev/zero; head -c 300000 /dev/zero >&2"});
  EXPECT_EQ(capture.out.size(), 300000U);
  EXPECT_EQ(capture.err.size(), 300000U);
}

TEST(CampaignCapture, SignalIs128AndItsNumber) { EXPECT_EQ(run_and_capture({"sh", "-c", "kill -9 $$"}).status, 137); }

TEST(CampaignScratch, IsGoneAfterwards) {
  std::filesystem::path path;
  {
    const ScratchDirectory scratch;
    path = scratch.path();
    rouleau::testing::set_content(path / "x", "x");
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace rouleau::campaign
