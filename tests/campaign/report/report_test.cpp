// SPDX-License-Identifier: BSD-3-Clause
// `rouleau report` and `rouleau render` as a user calls them, over a campaign of the real solver: before it runs, while
// it runs, after a crash, at its end, and without the programs that draw.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "commands/report_gnuplot.hpp"
#include "html_page.hpp"
#include "report/gnuplot_text.hpp"
#include "small_report.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using rouleau::testing::content_of;
using rouleau::testing::eventually;
using rouleau::testing::needs_of;
using rouleau::testing::set_content;
using rouleau::testing::small_study;
using rouleau::testing::Tag;
using rouleau::testing::tags_of;
using rouleau::testing::TemporaryDirectory;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// What tidy has to say of a page; its summary of no errors and warnings is silence.
std::string tidy(const std::filesystem::path& page) {
  if (!find_on_path("tidy")) return "";
  const Capture capture = run_and_capture({"tidy", "-q", "-e", page.string()});
  return capture.out + capture.err;
}

void expect_sound(const std::filesystem::path& file) {
  const std::string page = content_of(file);
  EXPECT_EQ(tidy(file), "");
  EXPECT_THAT(needs_of(page), IsEmpty());
  EXPECT_THAT(page, AllOf(HasSubstr("&lt;script&gt;alert"), Not(HasSubstr("<script"))));
  std::set<std::string> ids;
  for (const Tag& tag : tags_of(page)) {
    const auto id = tag.attributes.find("id");
    EXPECT_TRUE(id == tag.attributes.end() || ids.insert(id->second).second) << "twice: " << id->second;
    const bool is_picture = tag.name == "svg";
    EXPECT_TRUE(!is_picture || (tag.attributes.count("role") == 1 && tag.attributes.count("aria-label") == 1));
  }
  // Every link leads to a place of this page or to a directory that is there.
  for (const Tag& tag : tags_of(page)) {
    const auto link = tag.attributes.find("href");
    if (link == tag.attributes.end()) continue;
    const bool leads = link->second.starts_with('#') ? ids.count(link->second.substr(1)) == 1
                                                     : std::filesystem::is_directory(file.parent_path() / link->second);
    EXPECT_TRUE(leads) << link->second;
  }
}

std::size_t pictures_in(const std::string& page) {
  const std::vector<Tag> tags = tags_of(page);
  return static_cast<std::size_t>(
      std::count_if(tags.begin(), tags.end(), [](const Tag& tag) { return tag.name == "svg"; }));
}

/// One campaign for all tests; each looks at it only.
class FinishedCampaign {
 public:
  FinishedCampaign() : program(REAL_SOLVER_PROGRAM) {
    set_content(program.study(), small_study("0.008"));
    std::filesystem::create_directories(program.path() / "out");
  }
  CampaignProgram program;
};

CampaignProgram& finished() {
  static FinishedCampaign campaign;
  static const bool is_made = [] {
    EXPECT_EQ(campaign.program.init().status, 0);
    const Capture run = campaign.program.run();
    EXPECT_EQ(run.status, 0) << run.err;
    return true;
  }();
  static_cast<void>(is_made);
  return campaign.program;
}

TEST(Report, IsWholeBeforeTheCampaignRuns) {
  CampaignProgram program(REAL_SOLVER_PROGRAM);
  set_content(program.study(), small_study("0.008"));
  ASSERT_EQ(program.init().status, 0);
  const Capture report = program.rouleau({"report", "c"});
  ASSERT_EQ(report.status, 0) << report.err;
  expect_sound(program.campaign() / "report.html");
  EXPECT_THAT(content_of(program.campaign() / "report.html"),
              AllOf(HasSubstr("No point has a result yet"), HasSubstr("2 waiting")));
}

TEST(Report, FollowsARunningCampaignAndShowsItsCrash) {
  CampaignProgram program(REAL_SOLVER_PROGRAM);
  set_content(program.study(), small_study("0.02"));
  ASSERT_EQ(program.init().status, 0);
  const pid_t manager = program.start({"run", "c"});
  ASSERT_TRUE(eventually([&] {
    std::error_code error;
    return program.state(1) == State::running &&
           std::filesystem::directory_iterator(program.run_directory(1) / "checkpoints", error) !=
               std::filesystem::directory_iterator();
  }));
  const Capture during = program.rouleau({"report", "c", "-o", "during.html"});
  EXPECT_EQ(during.status, 0) << during.err;
  expect_sound(program.path() / "during.html");
  EXPECT_THAT(content_of(program.path() / "during.html"), HasSubstr("the campaign is not finished"));

  for (const pid_t job : program.jobs()) ::kill(job, SIGKILL);
  const Capture watch = program.rouleau({"report", "c", "--watch=1", "-o", "watched.html"});
  EXPECT_EQ(watch.status, 0) << watch.err;  // it ends by itself when all points are through
  EXPECT_GE(std::count(watch.err.begin(), watch.err.end(), '\n'), 2);
  EXPECT_EQ(CampaignProgram::wait_for(manager), 0) << program.messages();
  expect_sound(program.path() / "watched.html");
  const std::string page = content_of(program.path() / "watched.html");
  EXPECT_THAT(page,
              AllOf(HasSubstr("2 done"), HasSubstr("crashed"), HasSubstr("checkpoints/"), Not(HasSubstr("refresh"))));
}

TEST(Report, ShowsEveryPointInEveryWay) {
  const CampaignProgram& program = finished();
  const Capture report = program.rouleau({"report", "c"});
  ASSERT_EQ(report.status, 0) << report.err;
  EXPECT_THAT(report.err, Not(HasSubstr("note:")));
  const std::filesystem::path file = program.campaign() / "report.html";
  expect_sound(file);
  const std::string page = content_of(file);
  for (const char* id : {"phase-desc", "overlay-desc", "timeline-desc", "point-1-desc", "point-2-desc",
                         "shape-1-0-desc", "shape-2-0-desc", "slice-1-desc", "slice-2-desc"})
    EXPECT_THAT(page, HasSubstr(std::string("id=\"") + id + '"'));
  for (const int ordinal : {1, 2}) EXPECT_THAT(page, HasSubstr(program.point(ordinal).key));
  EXPECT_FALSE(std::filesystem::exists(program.path() / "pwned"));
}

TEST(Report, NeedsGnuplotForFiguresOnly) {
  const CampaignProgram& program = finished();
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  const Capture report = program.rouleau({"report", "c", "-o", "out/plain.html"});
  ::setenv("PATH", path.c_str(), 1);
  ASSERT_EQ(report.status, 0) << report.err;
  EXPECT_THAT(report.err, HasSubstr("gnuplot-nox"));
  expect_sound(program.path() / "out/plain.html");
  const std::string page = content_of(program.path() / "out/plain.html");
  EXPECT_THAT(page, AllOf(HasSubstr("gnuplot is not on the PATH"), HasSubstr(program.point(2).key),
                          Not(HasSubstr("phase-desc"))));
  EXPECT_GE(pictures_in(page), 4U);  // cells and slices are drawn without it
}

TEST(ReportFile, IsNeverWhatIsNoReport) {
  const CampaignProgram program(REAL_SOLVER_PROGRAM);
  set_content(program.study(), small_study("0.008"));
  ASSERT_EQ(program.init().status, 0);
  for (const char* name : {"c/campaign.db", "c/study.ini", "c/report"}) {
    const Capture report = program.rouleau({"report", "c", "-o", name});
    EXPECT_EQ(report.status, 2) << name;
    EXPECT_THAT(report.err, HasSubstr("ends in .html")) << name;
  }
  EXPECT_EQ(program.rouleau({"status", "c"}).status, 0) << "the database is whole";
}

TEST(Report, LeavesFiguresWithWhatTheyAreMadeOf) {
  const CampaignProgram& program = finished();
  const Capture report =
      program.rouleau({"report", "c", "-o", "out/r.html", "--figures", "pdf", "--figures-dir", "out/f"});
  ASSERT_EQ(report.status, 0) << report.err;
  const std::filesystem::path figures = program.path() / "out/f";
  for (const char* name : {"phase", "overlay", "timeline", "point-1", "point-2"}) {
    EXPECT_TRUE(content_of(figures / (std::string(name) + ".pdf")).starts_with("%PDF")) << name;
    EXPECT_FALSE(content_of(figures / (std::string(name) + ".dat")).empty());
    std::filesystem::remove(figures / (std::string(name) + ".pdf"));
    const Capture again = run_and_capture({"gnuplot", std::string(name) + ".gp"}, figures);
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_EQ(again.err, "");
    EXPECT_TRUE(std::filesystem::exists(figures / (std::string(name) + ".pdf")));
  }
  EXPECT_TRUE(std::filesystem::exists(figures / "cells-1.svg"));
}

TEST(Report, RefusesWhatItDoesNotKnow) {
  const CampaignProgram& program = finished();
  EXPECT_EQ(program.rouleau({"report", "c", "--figures", "png"}).status, 2);
  EXPECT_EQ(program.rouleau({"report", "c", "--figures-dir", "x"}).status, 2);
  EXPECT_EQ(program.rouleau({"report", "c", "--watch=0"}).status, 2);
  EXPECT_EQ(program.rouleau({"report", "nowhere"}).status, 3);
}

TEST(ReportFigures, RunNothingThatATextAsksFor) {
  TemporaryDirectory place;
  Figure figure;
  figure.name = "trap";
  figure.title = "two\nlines; system('touch pwned')";
  figure.data = "1 2\n";
  figure.script = "plot 'trap.dat' title " +
                  gnuplot_quoted("'; system('touch pwned'); `touch pwned` @pwned \"`touch pwned`\" \\") + "\n";
  ASSERT_EQ(draw_figures({&figure, 1}, place.path(), FigureFormat::svg), "");
  EXPECT_FALSE(std::filesystem::exists(place.path() / "pwned"));
  EXPECT_THAT(content_of(place.path() / "trap.svg"), HasSubstr("`touch pwned`"));
}

TEST(ReportFigures, OneThatFailsIsNamedAndTheOthersAreDrawn) {
  TemporaryDirectory place;
  Figure bad, good;
  bad.name = "bad";
  bad.script = "plot nonsense(\n";
  good.name = "good";
  good.data = "1 2\n";
  good.script = "plot 'good.dat'\n";
  const std::vector<Figure> figures = {bad, good};
  EXPECT_THAT(draw_figures(figures, place.path(), FigureFormat::svg),
              AllOf(HasSubstr("bad"), HasSubstr("bad.gp"), Not(HasSubstr("good"))));
  EXPECT_TRUE(std::filesystem::exists(place.path() / "good.svg"));
  EXPECT_FALSE(std::filesystem::exists(place.path() / "bad.svg"));
}

TEST(Render, DrawsTheCellInItsChannel) {
  const CampaignProgram& program = finished();
  const Capture newest = program.rouleau({"render", "lambda=5", "-C", "c", "-o", "out/cell.svg"});
  ASSERT_EQ(newest.status, 0) << newest.err;
  EXPECT_THAT(newest.err, HasSubstr("at 0.008 s"));
  EXPECT_THAT(content_of(program.path() / "out/cell.svg"), AllOf(HasSubstr("λ = 5, t = 0.008 s"), HasSubstr("5 µm")));
  const Capture early = program.rouleau({"render", "#2", "-C", "c", "--at", "0", "-o", "out/early.svg"});
  ASSERT_EQ(early.status, 0) << early.err;
  EXPECT_NE(content_of(program.path() / "out/early.svg"), content_of(program.path() / "out/cell.svg"));
  const Capture film = program.rouleau({"render", "#2", "-C", "c", "--film", "3", "-o", "out/film.svg"});
  ASSERT_EQ(film.status, 0) << film.err;
  EXPECT_THAT(film.err, HasSubstr("3 pictures"));
  EXPECT_EQ(program.rouleau({"render", "#1", "-C", "c"}).status, 0);
  EXPECT_TRUE(std::filesystem::exists(program.path() / "point-1.svg"));
}

TEST(Render, MakesPngWhereItCan) {
  const CampaignProgram& program = finished();
  const std::string path = std::getenv("PATH");
  if (find_on_path("rsvg-convert")) {
    ASSERT_EQ(program.rouleau({"render", "#1", "-C", "c", "-o", "out/cell.png"}).status, 0);
    EXPECT_TRUE(content_of(program.path() / "out/cell.png").starts_with("\x89PNG"));
  }
  ::setenv("PATH", "/nowhere", 1);
  const Capture without = program.rouleau({"render", "#1", "-C", "c", "-o", "out/other.png"});
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(without.status, 1);
  EXPECT_THAT(without.err, AllOf(HasSubstr("librsvg2-bin"), HasSubstr("other.svg")));
  EXPECT_TRUE(std::filesystem::exists(program.path() / "out/other.svg"));
}

TEST(Render, RefusesWhatItCannotDraw) {
  const CampaignProgram& program = finished();
  EXPECT_EQ(program.rouleau({"render", "-C", "c"}).status, 2);
  EXPECT_EQ(program.rouleau({"render", "#1", "#2", "-C", "c"}).status, 2);
  EXPECT_EQ(program.rouleau({"render", "#1", "-C", "c", "-o", "cell.jpg"}).status, 2);
  EXPECT_EQ(program.rouleau({"render", "#1", "-C", "c", "--at", "soon"}).status, 2);
  EXPECT_EQ(program.rouleau({"render", "#1", "-C", "c", "--film", "0"}).status, 2);
  EXPECT_EQ(program.rouleau({"render", "#1", "-C", "c", "--film", "2", "--at", "1"}).status, 2);
  EXPECT_EQ(program.rouleau({"render", "lambda=7", "-C", "c"}).status, 3);
}

}  // namespace
}  // namespace rouleau::campaign
