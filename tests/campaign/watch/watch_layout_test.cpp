// SPDX-License-Identifier: BSD-3-Clause
// The picture of a campaign: what stands in it, and that it fits.
#include "commands/watch_layout.hpp"

#include <gmock/gmock.h>

#include <regex>

#include "facts.hpp"
#include "report/fit_text.hpp"

namespace rouleau::campaign {
namespace {

using ::testing::AllOf;
using testing::end_step;
using testing::facts_of;
using testing::failed_point;
using ::testing::HasSubstr;
using testing::many;
using ::testing::Not;
using testing::point_at;
using testing::running_point;

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::string picture(const WatchFacts& facts, int columns, int rows) {
  return joined(watch_lines(facts, {columns, rows, false, false, true, "Ctrl-C leaves"}));
}

std::string line_with(const std::string& text, const std::string& part) {
  const std::size_t at = text.find(part);
  if (at == std::string::npos) return "";
  const std::size_t begin = text.rfind('\n', at) + 1;
  return text.substr(begin, text.find('\n', at) - begin);
}

WatchFacts three() {
  return facts_of({point_at(1, State::done, end_step), running_point(2, 36000), point_at(3, State::waiting, 0)});
}

struct Size {
  int points, columns, rows;
};
class WatchPicture : public ::testing::TestWithParam<Size> {};

TEST_P(WatchPicture, FitsTheTerminal) {
  const auto [points, columns, rows] = GetParam();
  const WatchFacts facts = points == 3 ? three() : many(points);
  for (const bool utf8 : {false, true}) {
    const std::vector<std::string> lines = watch_lines(facts, {columns, rows, false, utf8, true, "Ctrl-C leaves"});
    EXPECT_LE(std::ssize(lines), rows);
    for (const std::string& line : lines) EXPECT_LE(shown_width(line), static_cast<std::size_t>(columns)) << line;
    // Colour adds no width: without its sequences the picture is the same.
    const std::string coloured = joined(watch_lines(facts, {columns, rows, true, utf8, true, "Ctrl-C leaves"}));
    const std::string bare = std::regex_replace(coloured, std::regex("\033\\[[0-9;]*m"), "");
    EXPECT_EQ(std::regex_replace(bare, std::regex(" +\n"), "\n"),
              std::regex_replace(joined(lines), std::regex(" +\n"), "\n"));
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, WatchPicture,
                         ::testing::Values(Size{3, 80, 24}, Size{3, 200, 50}, Size{30, 80, 24}, Size{30, 200, 50},
                                           Size{3000, 80, 24}, Size{3000, 200, 50}, Size{3000, 40, 10},
                                           Size{3000, 20, 5}, Size{3000, 1, 1}, Size{30, 500, 3}));

TEST(WatchLayout, TellsOfEachPointWhatItsSolverSays) {
  const std::string text = picture(three(), 200, 50);
  const std::string line = line_with(text, "#2 ");
  for (const char* part : {"1.5", "running", "#####", "25 %", "36000 / 144000", "20.9", "3 min 36 s", "1 min 00 s ago",
                           "0.812", "croissant"})
    EXPECT_THAT(line, HasSubstr(part));
  for (const char* title : {"lambda", "MLUPS", "left", "checkpoint", "d, um", "class", "attempts"})
    EXPECT_THAT(line_with(text, "MLUPS"), HasSubstr(title));
  EXPECT_THAT(text, HasSubstr("small: 3 points: 1 waiting, 1 running, 1 done"));
  EXPECT_THAT(text, HasSubstr("#2 running -> done: exit.json says 0"));
}

TEST(WatchLayout, NarrowTerminalKeepsStateBarAndTimeLeft) {
  EXPECT_THAT(line_with(picture(three(), 80, 24), "#2 "),
              AllOf(HasSubstr("running"), HasSubstr("##"), HasSubstr("25 %"), HasSubstr("3 min 36 s"),
                    HasSubstr("0.812"), Not(HasSubstr("36000 / 144000"))));
  EXPECT_THAT(line_with(picture(three(), 30, 24), "#2 "), AllOf(HasSubstr("1.5"), HasSubstr("running")));
}

TEST(WatchLayout, TotalsAreThoseOfTheSteps) {
  const WatchFacts facts = three();
  EXPECT_DOUBLE_EQ(facts.fraction(), (144000 + 36000 + 0) / (3 * 144000.0));
  // 36000 steps at 500 a second on one core are 72 s; 252000 steps are left at that cost.
  EXPECT_DOUBLE_EQ(facts.core_h_used(), 72 / 3600.0);
  EXPECT_DOUBLE_EQ(facts.core_h_left().value(), 504 / 3600.0);
  EXPECT_DOUBLE_EQ(outlook_of(facts.points).left_s, 504);
  EXPECT_THAT(totals_text(facts), AllOf(HasSubstr("41 %, 0.02 core-h, ~0.14 left"), HasSubstr("in 8 min 24 s")));
}

TEST(WatchLayout, EndIsThatOfTheSlowestWhenNothingWaits) {
  WatchFacts facts = facts_of({running_point(1, 143500), running_point(2, 44000)});
  EXPECT_DOUBLE_EQ(outlook_of(facts.points).left_s, 200) << "not (500 + 100000) / 1000";
}

TEST(WatchLayout, CostsNothingThatIsNotKnown) {
  const WatchFacts facts = facts_of({point_at(1, State::waiting, 0)});
  EXPECT_FALSE(facts.core_h_left().has_value());
  EXPECT_EQ(totals_text(facts), "0 %, 0.00 core-h");
  EXPECT_THAT(picture(facts, 80, 24), HasSubstr("Nothing runs at this moment: `rouleau run` goes on."));
}

TEST(WatchLayout, FoldsWhatDoesNotFitBehindTheInterestingPoints) {
  const WatchFacts facts = many(3000);
  const std::vector<std::string> lines = watch_lines(facts, {80, 24, false, false, true, ""});
  const std::string text = joined(lines);
  EXPECT_THAT(text, HasSubstr("#7 "));
  EXPECT_THAT(line_with(text, "#1501 "), AllOf(HasSubstr("failed"), HasSubstr("velocity is not finite")));
  EXPECT_THAT(line_with(text, "#1502 "), HasSubstr("exhausted"));
  EXPECT_THAT(line_with(text, "#1503 "), HasSubstr("crashed"));
  EXPECT_THAT(text, Not(HasSubstr("#1 ")));
  // None is forgotten: those shown and those counted are all.
  const auto shown = std::count_if(lines.begin(), lines.end(), [](const std::string& line) {
    return std::regex_match(line, std::regex("#[0-9].*"));
  });
  EXPECT_THAT(text, HasSubstr(fmt::format("... {} more: ", 3000 - shown)));
}

TEST(WatchLayout, ShowsWaitingPointsBeforeThoseThatAreDone) {
  std::vector<PointStatus> points;
  for (int i = 1; i <= 100; ++i) points.push_back(point_at(i, i <= 90 ? State::done : State::waiting, 0));
  const std::string text = picture(facts_of(points), 80, 24);
  EXPECT_THAT(text, AllOf(HasSubstr("#91 "), HasSubstr("#100 ")));
  EXPECT_THAT(text, HasSubstr("#1 "));
  EXPECT_THAT(text, HasSubstr("done"));
}

TEST(WatchLayout, KeepsTheOrderOfThePointsWhileAllFit) {
  const std::string text = picture(many(10), 80, 40);
  for (int i = 1; i < 10; ++i)
    EXPECT_LT(text.find(fmt::format("\n#{} ", i)), text.find(fmt::format("\n#{} ", i + 1))) << i;
}

TEST(WatchLayout, TellsWhatSlurmSaysOfAPointInItsQueue) {
  PointStatus s = point_at(1, State::running, 0);
  s.is_queued = true;
  s.note = "job 4711: pending (Resources)";
  for (const int columns : {80, 200})
    EXPECT_THAT(line_with(picture(facts_of({s}), columns, 24), "#1 "),
                AllOf(HasSubstr("queued"), HasSubstr("job 4711: pending (Resources)")));
}

TEST(WatchLayout, ControlCharactersFromOutsideDoNotReachTheTerminal) {
  WatchFacts facts = facts_of({failed_point(1, State::failed,
                                            "\033[2Jgone\r\nand \xc2\x9b"
                                            "31m red\a")});
  facts.name = "a\033]0;b\a";
  facts.changes.front().evidence = "\033c";
  for (const char c : picture(facts, 200, 24)) EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20);
  EXPECT_THAT(picture(facts, 200, 24), Not(HasSubstr("\xc2\x9b")));
}

TEST(WatchLayout, SaysWhenAllIsOverAndWhatIsNext) {
  const WatchFacts facts = facts_of({point_at(1, State::done, end_step), failed_point(2, State::failed, "Mach")});
  EXPECT_TRUE(facts.is_over());
  EXPECT_THAT(picture(facts, 80, 24), AllOf(HasSubstr("All points are through"), Not(HasSubstr("ends ~"))));
  EXPECT_FALSE(three().is_over());
}

TEST(WatchLayout, WarningIsShownWhole) {
  WatchFacts facts = three();
  facts.warning =
      "paused: 5 points in a row failed early and alike (Mach 0.4 is above 0.3). Nothing more is started. "
      "Correct the cause, then `rouleau retry --all-failed` and `rouleau run`.";
  std::string text = picture(facts, 60, 24);
  std::replace(text.begin(), text.end(), '\n', ' ');
  EXPECT_THAT(text, HasSubstr(facts.warning));
}

TEST(WatchLayout, ChangeOfAnotherDayHasItsDate) {
  const Change change{1, testing::noon_unix_s, 3, "failed", "waiting", "asked for"};
  EXPECT_THAT(change_text(change, testing::noon_unix_s),
              ::testing::MatchesRegex("..:..:.. #3 failed -> waiting: asked for"));
  EXPECT_THAT(change_text(change, testing::noon_unix_s + 5 * 86400),
              ::testing::MatchesRegex("(1[345]|19) Nov ..:..:.. #3 failed -> waiting: asked for"));
}

TEST(WatchBar, IsFullOnlyWhenAllIsDone) {
  EXPECT_EQ(bar_text(0, 4, false), "....");
  EXPECT_EQ(bar_text(0.999, 4, false), "###.");
  EXPECT_EQ(bar_text(1, 4, false), "####");
  EXPECT_EQ(bar_text(7, 4, false), "####");
  EXPECT_EQ(bar_text(0.5, 2, true), "█░");
}

TEST(FitText, CutsByCharactersAndMarksTheCut) {
  EXPECT_EQ(fitted("λ = 5", 5), "λ = 5");
  EXPECT_EQ(fitted("λ = 5 and more", 8), "λ = 5...");
  EXPECT_EQ(fitted("abcdef", 2), "..");
  EXPECT_EQ(fitted("abcdef", 0), "");
  EXPECT_EQ(filled("λ", 3, true), "  λ");
}

}  // namespace
}  // namespace rouleau::campaign
