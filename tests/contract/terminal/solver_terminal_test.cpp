// SPDX-License-Identifier: BSD-3-Clause
// `rouleau-solver run.ini` by hand: one line that is drawn over in a terminal, lines elsewhere.
#include <gmock/gmock.h>

#include "restart/small_run.hpp"
#include "run/progress_bar.hpp"
#include "support/pseudo_terminal.hpp"

namespace rouleau::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

Progress progress_at(std::int64_t step) {
  Progress p;
  p.step = step;
  p.end_step = 144000;
  p.mlups = 20.94;
  p.eta_s = 258.2;
  p.checkpoint_unix_s = 1000;
  p.updated_unix_s = 1031.5;
  p.d_um = 0.81;
  return p;
}

TEST(ProgressLine, SaysAllThereIsRoomFor) {
  EXPECT_EQ(
      progress_line(progress_at(36000), 200),
      "[#####...............]  25 %  step 36000 / 144000  4 min 18 s left  20.9 MLUPS  d 0.810 um  checkpoint 31 s "
      "ago");
  EXPECT_EQ(progress_line(progress_at(36000), 79),
            "[#####...............]  25 %  step 36000 / 144000  4 min 18 s left  20.9 MLUPS");
  EXPECT_EQ(progress_line(progress_at(36000), 30), "[#####...............]  25 %");
  EXPECT_EQ(progress_line(progress_at(36000), 10), "");
}

TEST(ProgressLine, LeavesOutWhatHasNoValueYet) {
  Progress p = progress_at(0);
  p.eta_s.reset();
  p.d_um.reset();
  p.checkpoint_unix_s = 0;
  EXPECT_EQ(progress_line(p, 200), "[....................]   0 %  step 0 / 144000  20.9 MLUPS");
}

class SolverTerminal : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> words() const { return {ROULEAU_SOLVER, run_.path("run.ini").string()}; }
  SmallRun run_;
};

TEST_F(SolverTerminal, ShowsOneLineThatIsDrawnOverAndEnds) {
  run_.set_steps(200);
  PseudoTerminal terminal(words(), 200, 200);
  EXPECT_EQ(terminal.end(), 0) << terminal.picture.text();
  const std::string text = terminal.picture.text();
  EXPECT_THAT(text, HasSubstr("[####################] 100 %  step 200 / 200  "));
  EXPECT_EQ(text.find("[#"), text.rfind("[#")) << "one line, drawn over";
  EXPECT_THAT(text, HasSubstr("\nend time reached at step 200 of 200"));
}

TEST_F(SolverTerminal, FollowsTheWidth) {
  run_.set_steps(1000000);
  PseudoTerminal terminal(words(), 100, 200);
  ASSERT_TRUE(terminal.shows(" MLUPS"));
  terminal.resize(40, 200);
  ASSERT_TRUE(terminal.shows([](const TerminalPicture& p) { return p.text().find(" MLUPS") == std::string::npos; }));
  terminal.type("\x03");  // a checkpoint, then exit 75
  EXPECT_EQ(terminal.end(), 75);
  EXPECT_THAT(terminal.picture.text(), HasSubstr("\nstop requested by signal"));
}

TEST_F(SolverTerminal, DumbTerminalAndPipeGetLines) {
  run_.set_steps(32);
  PseudoTerminal terminal(words(), 200, 200, {{"TERM", "dumb"}});
  EXPECT_EQ(terminal.end(), 0);
  EXPECT_EQ(terminal.written.find('\033'), std::string::npos);
  EXPECT_THAT(terminal.written, HasSubstr("step        32 of 32"));
  SmallRun other;
  other.set_steps(32);
  const Finished finished = run_program({ROULEAU_SOLVER, other.path("run.ini").string()});
  EXPECT_EQ(finished.code, 0);
  EXPECT_THAT(finished.err, AllOf(HasSubstr("step        32 of 32"), Not(HasSubstr("\033"))));
}

TEST_F(SolverTerminal, QuietShowsNothing) {
  run_.set_steps(32);
  std::vector<std::string> quiet = words();
  quiet.emplace_back("--quiet");
  PseudoTerminal terminal(quiet, 100, 200);
  EXPECT_EQ(terminal.end(), 0);
  EXPECT_EQ(terminal.written, "");
}

}  // namespace
}  // namespace rouleau::testing
