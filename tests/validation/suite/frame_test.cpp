// SPDX-License-Identifier: BSD-3-Clause
// The frame of the validation suite: what fails is said to fail.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/error.hpp"
#include "campaign_run.hpp"
#include "case_file.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::validation {
namespace {

using rouleau::testing::content_of;
using rouleau::testing::set_content;
using rouleau::testing::TemporaryDirectory;

void holds(Suite& suite) { suite.check("a length", 2.01, near_relative(2, 0.01), "a book"); }
void is_wrong(Suite& suite) { suite.check("a length", 2.1, near_relative(2, 0.01), "a book"); }
void is_no_number(Suite& suite) { suite.check("a length", std::nan(""), near(2, 1e9), "a book"); }
void throws_late(Suite& suite) {
  holds(suite);
  fail(Exit::physics, "the cell is gone");
}
void only_tells(Suite& suite) { suite.figure("a length", 2); }

struct Outcome {
  int status;
  nlohmann::json list;
  std::string table;
};

Outcome outcome_of(const std::vector<Case>& cases) {
  const TemporaryDirectory place;
  std::ostringstream out;
  const int status = run_cases(cases, {place.path(), place.path(), place.path()}, place.path() / "result", out);
  EXPECT_EQ(content_of(place.path() / "result.txt"), out.str());
  return {status, nlohmann::json::parse(content_of(place.path() / "result.json")), out.str()};
}

TEST(Expected, ToleranceIsAbsoluteHoweverItWasGiven) {
  EXPECT_TRUE(near(2, 0.1).holds(2.0999));
  EXPECT_FALSE(near(2, 0.1).holds(2.1001));
  EXPECT_TRUE(near_relative(-2, 0.1).holds(-2.19));
  EXPECT_FALSE(near_relative(-2, 0.1).holds(-2.21));
  EXPECT_TRUE(between(1, 3).holds(1.0001));
  EXPECT_FALSE(between(1, 3).holds(0.999));
  EXPECT_FALSE(at_most(1e-3).holds(-1.1e-3));
  EXPECT_FALSE(near(0, 1).holds(std::nan("")));
}

TEST(ValidationFrame, ChecksThatHoldEndWithZero) {
  const Outcome outcome = outcome_of({{"good", "", holds}});
  EXPECT_EQ(outcome.status, 0);
  ASSERT_EQ(outcome.list.size(), 1U);
  for (const char* name : {"case", "quantity", "ours", "reference", "tolerance", "source", "pass"})
    EXPECT_TRUE(outcome.list[0].contains(name)) << name;
  EXPECT_EQ(outcome.list[0]["pass"], true);
  EXPECT_EQ(outcome.list[0]["reference"], 2.0);
}

TEST(ValidationFrame, WrongValueEndsWithOneAndIsMarkedAsFailed) {
  const Outcome outcome = outcome_of({{"bad", "", is_wrong}, {"good", "", holds}});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.list[0]["pass"], false);
  EXPECT_EQ(outcome.list[1]["pass"], true);
  EXPECT_NE(outcome.table.find("FAIL"), std::string::npos);
  EXPECT_NE(outcome.table.find("1 of 2 checks hold"), std::string::npos);
}

TEST(ValidationFrame, ValueThatIsNoNumberFails) {
  const Outcome outcome = outcome_of({{"bad", "", is_no_number}});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.list[0]["pass"], false);
  EXPECT_TRUE(outcome.list[0]["ours"].is_null());
}

TEST(ValidationFrame, CaseThatThrowsHasFailedWithItsMessageAndTheRestRuns) {
  const Outcome outcome = outcome_of({{"late", "", throws_late}, {"good", "", holds}});
  EXPECT_EQ(outcome.status, 1);
  ASSERT_EQ(outcome.list.size(), 3U);
  EXPECT_EQ(outcome.list[0]["pass"], true) << "what was found before stays";
  EXPECT_EQ(outcome.list[1]["case"], "late");
  EXPECT_EQ(outcome.list[1]["pass"], false);
  EXPECT_EQ(outcome.list[1]["note"], "the cell is gone");
  EXPECT_EQ(outcome.list[2]["pass"], true);
}

TEST(ValidationFrame, CaseThatChecksNothingHasFailed) {
  const Outcome outcome = outcome_of({{"silent", "", only_tells}});
  EXPECT_EQ(outcome.status, 1);
  ASSERT_EQ(outcome.list.size(), 1U) << "figures are in the table alone";
  EXPECT_NE(outcome.table.find("| a length"), std::string::npos);
}

TEST(CaseFile, NamesFileLineAndRemedy) {
  const TemporaryDirectory place;
  set_content(place.path() / "case.ini", "[flow]\nnodes = 10, 20\nspeed = fast\nunused = 1\n");
  CaseFile file(place.path() / "case.ini");
  EXPECT_EQ(file.numbers("flow", "nodes"), (std::vector<double>{10, 20}));
  const auto message_of = [](const auto& work) -> std::string {
    try {
      work();
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(message_of([&] { (void)file.number("flow", "speed"); }), "case.ini:3: speed = fast is not a number");
  EXPECT_EQ(message_of([&] { (void)file.number("flow", "width"); }),
            "case.ini: [flow] width is missing; the case needs it");
  EXPECT_EQ(message_of([&] { file.require_all_used(); }),
            "case.ini:4: [flow] unused is not known to this case; remove it");
}

/// Ten steps without a cell.
constexpr const char* small_study =
    "[study]\nname = small\n[channel]\nlength_x_um = 4\nlength_y_um = 4\nlength_z_um = 4\n[cell]\nshape = none\n"
    "[flow]\nmean_velocity_mm_per_s = 0.5\n[numerics]\nnode_spacing_um = 0.5\ntime_step_us = 1\n"
    "[time]\nend_time_s = 1e-5\n[output]\nsample_interval_steps = 5\n";

TEST(CampaignRun, RunsAStudyOnceAndReadsItsSamples) {
  const TemporaryDirectory place;
  set_content(place.path() / "small.ini", small_study);
  const Places places{place.path(), place.path() / "made", ROULEAU_PROGRAMS};
  for (int call = 0; call < 2; ++call) {
    const std::vector<CampaignPoint> points = run_campaign(places, "small");
    ASSERT_EQ(points.size(), 1U);
    EXPECT_EQ(points[0].series("step"), (std::vector<double>{0, 5, 10}));
    EXPECT_EQ(points[0].number("attempts"), 1) << "the second call reads what the first has run";
    EXPECT_THROW((void)points[0].series("no_such_column"), Error);
  }
  set_content(place.path() / "made" / "small.solver", "another build");
  set_content(place.path() / "made" / "small" / "mark", "");
  (void)run_campaign(places, "small");
  EXPECT_FALSE(std::filesystem::exists(place.path() / "made" / "small" / "mark")) << "made anew for another solver";
}

TEST(CampaignRun, StudyThatIsRefusedIsAnError) {
  const TemporaryDirectory place;
  set_content(place.path() / "small.ini", std::string(small_study) + "[fluid]\nlambda = 2\n");
  EXPECT_THROW((void)run_campaign({place.path(), place.path() / "made", ROULEAU_PROGRAMS}, "small"), Error);
}

TEST(CampaignRun, PointThatFailsIsNamed) {
  const TemporaryDirectory place;
  // No lattice counts the volume of a sphere to the last node: the first look at its health ends the run.
  set_content(place.path() / "strict.ini",
              "[study]\nname = strict\n[channel]\nlength_x_um = 9\nlength_y_um = 9\nlength_z_um = 9\n"
              "[cell]\nshape = sphere\nradius_um = 3\nsubdivisions = 3\n[flow]\nmean_velocity_mm_per_s = 0.1\n"
              "[numerics]\nnode_spacing_um = 0.5\ntime_step_us = 0.5\n[time]\nend_time_s = 1e-5\n"
              "[bounds]\ninside_ratio_min = 1\ninside_ratio_max = 1\n");
  const Places places{place.path(), place.path() / "made", ROULEAU_PROGRAMS};
  const std::string key = make_campaign(places, "strict").at(0).text("key");
  try {
    (void)run_campaign(places, "strict");
    FAIL() << "the point should be lost";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("point " + key + " is failed"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace rouleau::validation
