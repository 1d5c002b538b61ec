// SPDX-License-Identifier: BSD-3-Clause
// The page and its figures from data that a test makes: every point is there, and no text becomes markup.
#include "report/report_page.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "report/phase_figure.hpp"
#include "report/report_tables.hpp"
#include "report/series_figure.hpp"
#include "report/timeline_figure.hpp"
#include "small_campaign.hpp"

namespace rouleau::campaign {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string hostile = "\"><script>alert('x')</script>`id`'; system('id') #\\";

ReportPoint point_of(int ordinal, double lambda, const std::string& phase = "") {
  ReportPoint point;
  point.row.key = fmt::format("{:012x}", ordinal);
  point.row.ordinal = ordinal;
  point.row.state = phase.empty() ? State::waiting : State::done;
  point.row.end_step = 1000;
  point.swept = {{"fluid.lambda", fmt::format("{}", lambda), lambda, true}};
  point.lambda = lambda;
  point.link = "points/" + point.row.key + "/";
  if (phase.empty()) return point;
  ResultRow result;
  result.d_mean_um = phase == "slipper" ? 0.8 : 0.1;
  result.d_error_um = 0.02;
  result.phase = phase;
  result.step = 1000;
  point.results = {result};
  point.curves = {{0, {0, 0.1, 0.2}, {0.5, 0.4, *result.d_mean_um}, {0.15, 0.2, 0.1}}};
  return point;
}

AttemptRow attempt_of(int number, double started, std::optional<double> ended, std::optional<int> code) {
  AttemptRow attempt;
  attempt.number = number;
  attempt.state = ended ? AttemptState::ended : AttemptState::launched;
  attempt.started_unix_s = started;
  attempt.ended_unix_s = ended;
  attempt.exit_code = code;
  attempt.host = "n1";
  return attempt;
}

ReportData data_of(std::vector<ReportPoint> points) {
  ReportData data;
  data.campaign.name = "small";
  data.swept = {"fluid.lambda"};
  data.points = std::move(points);
  data.written_unix_s = 1.7e9;
  return data;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++found;
  return found;
}

TEST(ReportData, ReadsPointsInTheOrderOfTheirAxis) {
  const testing::SmallCampaign small;
  const ReportData data = read_report(small.store, 2000);
  ASSERT_EQ(data.points.size(), 4U);
  EXPECT_EQ(data.points[1].label(), "λ = 4.75");
  EXPECT_EQ(data.points[1].result()->phase, "undecided");
  EXPECT_EQ(data.points[3].result(), nullptr);
  EXPECT_FALSE(data.is_finished());
  EXPECT_THAT(data.numeric_axes(), ::testing::ElementsAre("fluid.lambda"));
}

TEST(ReportPage, HasEveryPointWithoutAnyResult) {
  const std::string page = report_page(data_of({point_of(1, 1), point_of(2, 5)}), {});
  EXPECT_THAT(page, AllOf(HasSubstr("No point has a result yet"), HasSubstr("points/000000000001/"),
                          HasSubstr("points/000000000002/"), HasSubstr("2 waiting"), Not(HasSubstr("<figure>"))));
}

TEST(ReportPage, EscapesEveryTextOfOthers) {
  ReportPoint point = point_of(1, 1, "slipper");
  point.swept.push_back({"cell.mesh_file", hostile, std::nullopt, true});
  point.results[0].phase_reason = hostile;
  point.identity = point.run_file_digest = hostile;
  point.link = hostile;
  point.attempts = {attempt_of(1, 1.6e9, 1.7e9, 0)};
  point.attempts[0].host = point.attempts[0].reason = point.attempts[0].version = point.attempts[0].git = hostile;
  point.attempts[0].job_id = point.attempts[0].resumed_from = hostile;
  ReportPoint other = point;
  other.row.ordinal = 2;
  ReportData data = data_of({point, other});
  data.swept.push_back("cell.mesh_file");
  data.campaign.name = data.campaign.study_text = data.campaign.study_digest = data.campaign.version = hostile;
  PageParts parts;
  parts.notes = {hostile};
  Figure figure = series_figure(data, point).value();
  parts.series[1] = {figure, "<svg></svg>"};
  const std::string page = report_page(data, parts);
  EXPECT_EQ(count(page, "<script"), 0U);
  EXPECT_EQ(count(page, "alert('x')"), 0U);
  EXPECT_GE(count(page, "&lt;script&gt;"), 10U);
  for (const Figure& drawn :
       {figure, phase_figure(data).value(), overlay_figure(data, 100).value(), timeline_figure(data).value()}) {
    // Only within single quotes, which none of its own ends, or in comments.
    EXPECT_EQ(count(drawn.script, "t('x')"), 0U) << drawn.script;
    EXPECT_EQ(count(drawn.data, "\n\""), 0U);
  }
}

TEST(ReportPage, AsksNobodyForAnything) {
  PageParts parts;
  parts.refresh_s = 60;
  const std::string page = report_page(data_of({point_of(1, 1, "slipper")}), parts);
  for (const char* loader : {"http://", "https://", "src=", "<link", "<script", "@import", "url("})
    EXPECT_THAT(page, Not(HasSubstr(loader)));
  EXPECT_THAT(page,
              AllOf(HasSubstr("<meta name=\"viewport\""), HasSubstr("@media print"), HasSubstr("content=\"60\"")));
}

TEST(ReportPage, FoldsManyPoints) {
  std::vector<ReportPoint> points;
  PageParts parts;
  for (int i = 1; i <= 200; ++i) {
    points.push_back(point_of(i, i, i <= 80 ? "croissant" : "slipper"));
    parts.series[i] = {Figure{}, "<svg></svg>"};
  }
  const std::string page = report_page(data_of(points), parts);
  EXPECT_THAT(page, AllOf(HasSubstr("<details><summary>croissant: 80 points"), HasSubstr("slipper: 120 points"),
                          HasSubstr("Table of 200 points")));
  EXPECT_EQ(count(page, "<figure>"), 200U);
  points.resize(8);
  parts.series.erase(parts.series.upper_bound(8), parts.series.end());
  EXPECT_THAT(report_page(data_of(points), parts), Not(HasSubstr("<summary>croissant")));
}

TEST(ReportPhaseFigure, TellsClassesByColourAndShape) {
  const ReportData data = data_of({point_of(1, 1, "croissant"), point_of(2, 5, "slipper"), point_of(3, 8)});
  const Figure figure = phase_figure(data).value();
  EXPECT_THAT(figure.script, AllOf(HasSubstr("pt 7 ps 1.1 lc rgb '#0072B2' title 'croissant'"),
                                   HasSubstr("pt 9 ps 1.1 lc rgb '#D55E00' title 'slipper'")));
  EXPECT_THAT(figure.data, HasSubstr("\n5 0 0.8 0.02 1 1 2\n")) << figure.data;
  EXPECT_FALSE(phase_figure(data_of({point_of(1, 1)})).has_value());
}

TEST(ReportPhaseFigure, MapsTwoAxesWithTheirBoundary) {
  std::vector<ReportPoint> points;
  for (const double v : {1.0, 2.0})
    for (const double lambda : {3.0, 4.0, 5.0}) {
      points.push_back(
          point_of(static_cast<int>(points.size()) + 1, lambda, lambda < 3.5 + v / 2 ? "croissant" : "slipper"));
      points.back().swept.push_back({"flow.mean_velocity_mm_per_s", fmt::format("{}", v), v, true});
    }
  ReportData data = data_of(points);
  EXPECT_FALSE(map_figure(data).has_value());  // one axis
  data.swept.push_back("flow.mean_velocity_mm_per_s");
  const Figure figure = map_figure(data).value();
  EXPECT_THAT(figure.script, AllOf(HasSubstr("'mean velocity, mm/s'"), HasSubstr("title 'boundary'")));
  EXPECT_THAT(figure.data, AllOf(HasSubstr("\n3.5 1 3 4\n"), HasSubstr("\n4.5 2 4 5\n"))) << figure.data;
}

TEST(ReportSeriesFigure, LegendNamesTheAxesThatTellPointsApartAndFits) {
  const auto point_with = [](int ordinal, double lambda, double step, const std::string& kernel) {
    ReportPoint point = point_of(ordinal, lambda, "croissant");
    point.swept.push_back({"numerics.time_step_us", fmt::format("{}", step), step, true});
    point.swept.push_back({"numerics.kernel", kernel, std::nullopt, true});
    return point;
  };
  ReportData data = data_of({point_with(1, 1, 25 / 81.0, "2-point"), point_with(2, 5, 25 / 81.0, "2-point"),
                             point_with(3, 5, 50 / 81.0, "4-point")});
  data.swept = {"fluid.lambda", "numerics.time_step_us", "numerics.kernel"};
  std::string script = overlay_figure(data, 100).value().script;
  EXPECT_THAT(script, AllOf(HasSubstr("title 'λ = 1, 2-point'"), HasSubstr("title 'λ = 5, 2-point'"),
                            HasSubstr("title 'λ = 5, 4-point'"), Not(HasSubstr("time step"))));

  data.points.push_back(point_with(4, 5, 50 / 81.0, "4-point"));  // the same twice: only the number tells
  script = overlay_figure(data, 100).value().script;
  EXPECT_THAT(script, AllOf(HasSubstr("title '#3 λ = 5, 4-point'"), HasSubstr("title '#4 λ = 5, 4-point'")));

  data.points[3].swept[2].text = std::string(80, 'k');  // gnuplot would leave such an entry out
  script = overlay_figure(data, 100).value().script;
  EXPECT_THAT(script, AllOf(HasSubstr("title '#1 λ = 1"), HasSubstr("title '#4 λ = 5, kkk"), HasSubstr("...'")));
  EXPECT_THAT(script, Not(HasSubstr(std::string(36, 'k'))));
}

TEST(ReportSeriesFigure, GroupsManyCurvesByClassWithinABudget) {
  std::vector<ReportPoint> points;
  for (int i = 1; i <= 200; ++i) {
    points.push_back(point_of(i, i, i <= 80 ? "croissant" : "slipper"));
    Curve& curve = points.back().curves[0];
    for (int k = 0; k < 2000; ++k) {
      curve.time_s.push_back(k);
      curve.d_um.push_back(k % 7);
      curve.asphericity.push_back(0.1);
    }
  }
  const Figure figure = overlay_figure(data_of(points), 24000).value();
  EXPECT_THAT(figure.script,
              AllOf(HasSubstr("set title 'croissant'"), HasSubstr("set title 'slipper'"), HasSubstr("lc palette")));
  EXPECT_LE(count(figure.data, "\n"), 24000U + 4 * 200U + 2);  // and a heading and two blank lines a curve
}

TEST(ReportTimeline, TellsHowAttemptsEndedAndHowLongTheyWaited) {
  EXPECT_EQ(end_of(attempt_of(1, 0, 10, 0)), End::finished);
  EXPECT_EQ(end_of(attempt_of(1, 0, 10, 75)), End::stopped);
  EXPECT_EQ(end_of(attempt_of(1, 0, 10, 70)), End::failed);
  EXPECT_EQ(end_of(attempt_of(1, 0, 10, std::nullopt)), End::crashed);
  EXPECT_EQ(end_of(attempt_of(1, 0, 10, 74)), End::crashed);
  EXPECT_EQ(end_of(attempt_of(1, 0, std::nullopt, std::nullopt)), End::running);

  ReportPoint point = point_of(1, 1, "slipper");
  point.attempts = {attempt_of(1, 1000, 4600, std::nullopt), attempt_of(2, 5000, std::nullopt, std::nullopt)};
  point.attempts[0].engine = point.attempts[1].engine = "slurm";
  point.began_unix_s[1] = 2800;
  const Bar first = bar_of(point, point.attempts[0], 8600), second = bar_of(point, point.attempts[1], 8600);
  EXPECT_EQ(first.begun - first.submitted, 1800);
  EXPECT_EQ(second.begun, 8600);  // it waits still
  ReportData data = data_of({point});
  data.written_unix_s = 8600;
  const Figure figure = timeline_figure(data).value();
  EXPECT_THAT(figure.data, AllOf(HasSubstr("0 0.5 1 6 1\n"), HasSubstr("0.5 1 1 2 1\n"))) << figure.data;
  EXPECT_THAT(figure.description, HasSubstr("1 of them crashed, 2 waited"));
  EXPECT_FALSE(timeline_figure(data_of({point_of(1, 1)})).has_value());
}

TEST(ReportTables, CountTheCostOfWhatLeftNoRecord) {
  ReportPoint point = point_of(1, 1, "slipper");
  point.attempts = {attempt_of(1, 0, 7200, std::nullopt), attempt_of(2, 7200, 10800, 0)};
  point.attempts[0].ranks = 2;
  point.attempts[1].core_s = point.attempts[1].wall_s = 3600;
  const std::string cost = cost_table(data_of({point}));
  EXPECT_THAT(cost, AllOf(HasSubstr("1, as recorded"), HasSubstr("about 4 core-hours by the clock, of 1 starts"),
                          HasSubstr("1 finished; 1 crashed")));
}

}  // namespace
}  // namespace rouleau::campaign
