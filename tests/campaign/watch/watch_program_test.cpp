// SPDX-License-Identifier: BSD-3-Clause
// `rouleau status --watch` in a pseudo-terminal, and into a pipe, as its user sees it.
#include <gmock/gmock.h>

#include "executor/capture.hpp"
#include "study/error.hpp"
#include "support/campaign_program.hpp"
#include "support/pseudo_terminal.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using rouleau::testing::eventually;
using rouleau::testing::PseudoTerminal;
using rouleau::testing::TerminalPicture;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Watch : public ::testing::Test {
 protected:
  /// Two of the points run, so slowly that they do until they are stopped.
  void begin(const std::string& sweep = "fluid.lambda = 1, 2, 3") {
    CampaignProgram::set_speed(20000, 10);
    program_.write_study(sweep, CampaignProgram::execution(), "1");
    ASSERT_EQ(program_.init().status, 0);
    run_ = program_.start({"run", "c"});
    ASSERT_TRUE(eventually([&] { return has_progress(1) && has_progress(2); })) << program_.messages();
  }
  /// Stops the jobs behind checkpoints.
  void stop() {
    if (run_ == 0) return;
    ::kill(run_, SIGINT);
    EXPECT_EQ(CampaignProgram::wait_for(std::exchange(run_, 0)), 130);
  }
  ~Watch() override { stop(); }

  bool has_progress(int ordinal) const {
    return std::filesystem::exists(program_.run_directory(ordinal) / "progress.json");
  }
  [[nodiscard]] std::vector<std::string> words(const std::string& option = "--watch=0.2") const {
    return {ROULEAU_PROGRAM, "status", program_.campaign().string(), option};
  }

  /// A campaign of so many points that only its database knows: the second failed, the others wait.
  void write_database(int count) const {
    std::filesystem::create_directory(program_.campaign());
    const std::string study = rouleau::testing::content_of(program_.study());
    Store store = Store::create(program_.campaign() / "campaign.db", {"small", study, digest_of(study), 1, "", ""});
    Transaction transaction = store.begin();
    for (int i = 1; i <= count; ++i) {
      PointRow point;
      point.key = fmt::format("{:012x}", i);
      point.ordinal = i;
      point.end_step = 1000;
      store.add_point(point, {{"fluid.lambda", fmt::format("{}", i), 1.0 * i, true}}, "added");
    }
    AttemptRow attempt;
    attempt.point = fmt::format("{:012x}", 2);
    attempt.number = 1;
    attempt.token = "t";
    attempt.state = AttemptState::ended;
    attempt.reason = "Mach 0.4 is above 0.3";
    store.put_attempt(attempt);
    store.change_state(attempt.point, State::waiting, State::failed, "exit.json says 70: Mach 0.4 is above 0.3", 1);
    transaction.commit();
  }

  CampaignProgram program_;
  pid_t run_ = 0;
};

/// Ctrl-C, after which the terminal is as before.
void leave(PseudoTerminal& terminal) {
  EXPECT_EQ(terminal.picture.overflows, 0);
  terminal.type("\x03");
  EXPECT_EQ(terminal.end(), 0);
  EXPECT_FALSE(terminal.picture.is_second);
  EXPECT_TRUE(terminal.picture.cursor_is_shown);
  EXPECT_TRUE(terminal.picture.wraps);
}

TEST_F(Watch, ShowsRunningPointsAndCtrlCGivesTheTerminalBack) {
  begin();
  PseudoTerminal terminal(words(), 80, 24);
  ASSERT_TRUE(terminal.shows("#3")) << terminal.picture.text();
  EXPECT_TRUE(terminal.picture.is_second);
  EXPECT_THAT(terminal.picture.text(), AllOf(HasSubstr("small: 3 points: 1 waiting, 2 running"), HasSubstr("λ"),
                                             HasSubstr("Last changes"), HasSubstr("Ctrl-C leaves")));
  EXPECT_GT(terminal.picture.colours, 0);
  leave(terminal);
  EXPECT_THAT(terminal.picture.text(), HasSubstr("#3")) << "what was seen last stays";
}

TEST_F(Watch, IsDrawnAnewAsTheRunGoesOn) {
  begin();
  PseudoTerminal terminal(words(), 200, 50);
  ASSERT_TRUE(terminal.shows("step / end")) << terminal.picture.text();
  const std::string before = terminal.picture.text();
  EXPECT_TRUE(terminal.shows([&](const TerminalPicture& p) { return p.text() != before; }));
  stop();
  EXPECT_TRUE(terminal.shows("running -> stopped")) << terminal.picture.text();
  EXPECT_TRUE(terminal.shows("Nothing runs at this moment"));
  ::kill(terminal.pid(), SIGTERM);
  EXPECT_EQ(terminal.end(), 0);
  EXPECT_FALSE(terminal.picture.is_second);
  EXPECT_TRUE(terminal.picture.cursor_is_shown);
  EXPECT_EQ(terminal.picture.second_screens, 1) << "it was taken once, not at every redraw";
}

TEST_F(Watch, FollowsTheSizeOfTheTerminal) {
  begin();
  PseudoTerminal terminal(words("--watch=1000"), 200, 50);  // no redraw but for the size
  ASSERT_TRUE(terminal.shows("attempts")) << terminal.picture.text();
  terminal.resize(60, 12);
  ASSERT_TRUE(terminal.shows([](const TerminalPicture& p) {
    const std::string text = p.text();
    return text.find("attempts") == std::string::npos && text.find("running") != std::string::npos;
  })) << terminal.picture.text();
  EXPECT_EQ(terminal.picture.overflows, 0);
  terminal.resize(200, 50);
  EXPECT_TRUE(terminal.shows("attempts")) << terminal.picture.text();
  leave(terminal);
}

TEST_F(Watch, CtrlZGivesTheTerminalBackUntilItGoesOn) {
  begin();
  PseudoTerminal terminal(words("--watch=1000"), 80, 24);
  ASSERT_TRUE(terminal.shows("#3"));
  ::kill(terminal.pid(), SIGTSTP);
  ASSERT_TRUE(terminal.shows([](const TerminalPicture& p) { return !p.is_second && p.cursor_is_shown; }));
  int status = 0;
  ASSERT_EQ(::waitpid(terminal.pid(), &status, WUNTRACED), terminal.pid());
  ASSERT_TRUE(WIFSTOPPED(status));
  ::kill(terminal.pid(), SIGCONT);
  ASSERT_TRUE(terminal.shows([](const TerminalPicture& p) { return p.is_second; }));
  leave(terminal);
}

TEST_F(Watch, EndsWithTheCampaignAndLeavesTheLastPicture) {
  begin();
  PseudoTerminal terminal(words(), 80, 24);
  ASSERT_TRUE(terminal.shows("#3"));
  stop();
  CampaignProgram::set_speed(10, 1000);
  ASSERT_EQ(program_.run().status, 0);
  EXPECT_EQ(terminal.end(), 0);
  EXPECT_FALSE(terminal.picture.is_second);
  EXPECT_TRUE(terminal.picture.cursor_is_shown);
  EXPECT_THAT(terminal.picture.text(),
              AllOf(HasSubstr("3 points: 3 done"), HasSubstr("All points are through"), HasSubstr("100 %")));
  // One that is through already: its picture, once.
  PseudoTerminal again(words(), 80, 24);
  EXPECT_EQ(again.end(), 0);
  EXPECT_EQ(again.picture.second_screens, 0);
  EXPECT_THAT(again.picture.text(), HasSubstr("All points are through"));
}

TEST_F(Watch, NoColorIsHonoured) {
  begin();
  PseudoTerminal terminal(words(), 80, 24, {{"NO_COLOR", "1"}, {"LC_ALL", "C"}});
  ASSERT_TRUE(terminal.shows("#3"));
  leave(terminal);
  EXPECT_EQ(terminal.picture.colours, 0);
  for (const char c : terminal.written) ASSERT_LT(static_cast<unsigned char>(c), 0x80) << "the locale is not UTF-8";
}

TEST_F(Watch, DumbTerminalGetsLines) {
  begin();
  PseudoTerminal terminal(words(), 200, 24, {{"TERM", "dumb"}});
  ASSERT_TRUE(terminal.shows("small: 1 waiting, 2 running"));
  leave(terminal);
  EXPECT_EQ(terminal.written.find('\033'), std::string::npos);
}

TEST_F(Watch, PipeGetsChangesAndTotalsAsLines) {
  begin();
  const std::filesystem::path log = program_.path() / "log";
  std::thread watcher([&] {
    const auto capture = run_and_capture(words(), program_.path());
    EXPECT_EQ(capture.status, 0) << capture.err;
    rouleau::testing::set_content(log, capture.out);
  });
  stop();
  CampaignProgram::set_speed(10, 1000);
  EXPECT_EQ(program_.run().status, 0);
  watcher.join();
  const std::string text = rouleau::testing::content_of(log);
  EXPECT_EQ(text.find('\033'), std::string::npos);
  EXPECT_THAT(text, AllOf(HasSubstr("#3 running -> done"), HasSubstr("small: 3 done; 100 %")));
  // Every change once.
  const std::string change = "#3 running -> done";
  EXPECT_EQ(text.find(change), text.rfind(change));
}

TEST_F(Watch, AnyNumberOfPointsFitsBothTerminals) {
  program_.write_study("fluid.lambda = 1", CampaignProgram::execution());
  for (const int count : {3, 30, 3000}) {
    write_database(count);
    for (const auto& [columns, rows] : {std::pair{80, 24}, std::pair{200, 50}}) {
      PseudoTerminal terminal(words(), columns, rows);
      ASSERT_TRUE(terminal.shows("Ctrl-C leaves")) << terminal.picture.text();
      ASSERT_TRUE(terminal.shows("Last changes")) << terminal.picture.text();
      EXPECT_THAT(terminal.picture.text(), AllOf(HasSubstr(fmt::format("{} points: ", count)), HasSubstr("#2 "),
                                                 HasSubstr("Mach 0.4 is above 0.3")));
      const bool all_fit = count + 12 < rows;
      EXPECT_EQ(terminal.picture.text().find(" more: ") == std::string::npos, all_fit);
      leave(terminal);
    }
    std::filesystem::remove_all(program_.campaign());
  }
}

TEST_F(Watch, OutlivesADatabaseThatCannotBeRead) {
  program_.write_study("fluid.lambda = 1, 2, 3", CampaignProgram::execution());
  ASSERT_EQ(program_.init().status, 0);
  const std::filesystem::path database = program_.campaign() / "campaign.db", aside = program_.path() / "aside";
  PseudoTerminal terminal(words(), 200, 24);
  ASSERT_TRUE(terminal.shows("#3"));
  std::filesystem::rename(database, aside);
  EXPECT_TRUE(terminal.shows("as of ")) << terminal.picture.text();
  EXPECT_THAT(terminal.picture.text(), HasSubstr("#3"));
  std::filesystem::rename(aside, database);
  EXPECT_TRUE(terminal.shows([](const TerminalPicture& p) { return p.text().find("as of ") == std::string::npos; }));
  leave(terminal);
}

TEST_F(Watch, ExitCodeTellsOfFailuresWhenAskedTo) {
  program_.write_study("fluid.lambda = 1", CampaignProgram::execution());
  ASSERT_EQ(program_.init().status, 0);
  program_.script(1, "exit 70 20\n");
  EXPECT_EQ(program_.run().status, 4);
  EXPECT_EQ(program_.rouleau({"status", "c", "--watch"}).status, 0);
  EXPECT_EQ(program_.rouleau({"status", "c", "--watch", "--exit-code"}).status, 4);
}

TEST(WatchOptions, WrongOnesAreNamed) {
  const CampaignProgram program;
  for (const char* option : {"--watch=0", "--watch=-1", "--watch=soon", "--watch=1e9"}) {
    const auto capture = program.rouleau({"status", option});
    EXPECT_EQ(capture.status, 2) << option;
    EXPECT_THAT(capture.err, HasSubstr("seconds from 0.1 to 86400")) << option;
  }
  EXPECT_EQ(program.rouleau({"status", "--watch", "nowhere"}).status, 3) << "it names the campaign";
  EXPECT_EQ(program.rouleau({"status", "--watch=2", "--format", "json"}).status, 2);
  EXPECT_EQ(program.rouleau({"status", "nowhere", "--watch"}).status, 3);
}

}  // namespace
}  // namespace rouleau::campaign
