// SPDX-License-Identifier: BSD-3-Clause
// Small pure parts of a report: escaping, thinning, words, where the class changes.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "report/boundary.hpp"
#include "report/gnuplot_text.hpp"
#include "report/inline_svg.hpp"
#include "report/markup.hpp"
#include "report/parameter_words.hpp"
#include "report/report_tables.hpp"
#include "report/thin.hpp"

namespace rouleau::campaign {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(ReportMarkup, LeavesNoCharacterThatOpensMarkup) {
  EXPECT_EQ(escaped("<script>a & \"b\" 'c'</script>"),
            "&lt;script&gt;a &amp; &quot;b&quot; &#39;c&#39;&lt;/script&gt;");
  EXPECT_EQ(escaped("λ = 5 µm"), "λ = 5 µm");
}

TEST(ReportMarkup, ReplacesWhatIsNoText) {
  const std::string sign = "\xEF\xBF\xBD";
  EXPECT_EQ(escaped(std::string("a\0b\x1b[31m\x7f", 9)), "a" + sign + "b" + sign + "[31m" + sign);
  EXPECT_EQ(escaped("\xff"), sign);
  EXPECT_EQ(escaped("\xc3"), sign);                        // cut short
  EXPECT_EQ(escaped("\xc0\xbc"), sign + sign);             // `<` in too many bytes
  EXPECT_EQ(escaped("\xed\xa0\x80"), sign + sign + sign);  // half a surrogate pair
  EXPECT_EQ(escaped("a\r\nb\rc\td"), "a\nb\nc\td");
}

TEST(ReportMarkup, LinksKeepWithinTheirPath) {
  EXPECT_EQ(link_to("../my campaign/points/4f1c/"), "../my%20campaign/points/4f1c/");
  EXPECT_EQ(link_to("javascript:x?y#z\""), "javascript%3Ax%3Fy%23z%22");
}

TEST(ReportGnuplot, QuotesEndOnlyWhereTheyShould) {
  EXPECT_EQ(gnuplot_quoted("it's `id` @x \\ \"y\"\nquit"), "'it’s `id` @x \\ \"y\" quit'");
  EXPECT_EQ(gnuplot_comment("two\nlines\\"), "# two lines\\.\n");
  EXPECT_EQ(gnuplot_number(std::numeric_limits<double>::infinity()), "NaN");
  EXPECT_EQ(gnuplot_number(std::nullopt), "NaN");
  EXPECT_EQ(gnuplot_number(0.125), "0.125");
}

TEST(ReportThinning, KeepsEndsAndPeaks) {
  std::vector<double> values(100000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::sin(1e-3 * static_cast<double>(i));
  values[54321] = 7;
  values[12345] = -7;
  values[777] = std::nan("");
  const std::vector<std::size_t> kept = thinned(values, 2000);
  EXPECT_LE(kept.size(), 2000U);
  EXPECT_GT(kept.size(), 1900U);
  EXPECT_EQ(kept.front(), 0U);
  EXPECT_EQ(kept.back(), values.size() - 1);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  EXPECT_EQ(std::adjacent_find(kept.begin(), kept.end()), kept.end());
  EXPECT_THAT(kept, AllOf(::testing::Contains(54321U), ::testing::Contains(12345U)));
}

TEST(ReportThinning, LeavesAShortSeriesAlone) {
  EXPECT_THAT(thinned(std::vector<double>{3, 1, 2}, 4), ElementsAre(0, 1, 2));
  EXPECT_TRUE(thinned(std::vector<double>{}, 4).empty());
}

TEST(ReportThinning, SpreadsOverTimeRatherThanOverFiles) {
  const std::vector<double> steps = {0, 100, 600, 950, 990, 1000};
  EXPECT_THAT(spread_evenly(steps, 3), ElementsAre(0, 2, 5));
  EXPECT_THAT(spread_evenly(steps, 1), ElementsAre(5));
  EXPECT_THAT(spread_evenly(steps, 100), ::testing::Contains(5));
  EXPECT_THAT(spread_evenly(std::vector<double>{4}, 6), ElementsAre(0));
  EXPECT_TRUE(spread_evenly(std::vector<double>{}, 6).empty());
}

TEST(ReportWords, SplitUnitsFromNames) {
  EXPECT_EQ(axis_title("fluid.lambda"), "λ");
  EXPECT_EQ(axis_title("flow.mean_velocity_mm_per_s"), "mean velocity, mm/s");
  EXPECT_EQ(axis_title("cell.replica"), "replica");
  EXPECT_EQ(parameter_words("cell.radius_um", "4"), "radius = 4 µm");
}

TEST(ReportWords, ErrorsDecideTheDigits) {
  EXPECT_EQ(with_error(0.51967, 0.02455), "0.520 ± 0.025");
  EXPECT_EQ(with_error(12.3456, 1.5), "12.3 ± 1.5");
  EXPECT_EQ(with_error(0.51967, std::nullopt), "0.52");
  EXPECT_EQ(with_error(std::nullopt, 0.1), "–");
}

TEST(ReportBoundary, LiesBetweenNeighboursOfBothClasses) {
  const std::vector<Classified> points = {{5, 1, "slipper"},   {4, 1, "croissant"}, {4.5, 1, "undecided"},
                                          {3, 1, "croissant"}, {8, 2, "slipper"},   {6, 2, "croissant"}};
  const std::vector<Crossing> crossings = boundary(points);
  ASSERT_EQ(crossings.size(), 2U);
  EXPECT_THAT(crossings[0], AllOf(Field(&Crossing::y, 1), Field(&Crossing::low, 4), Field(&Crossing::high, 5)));
  EXPECT_THAT(crossings[1], AllOf(Field(&Crossing::y, 2), Field(&Crossing::low, 6), Field(&Crossing::high, 8)));
}

TEST(ReportBoundary, IsNowhereWithinOneClass) {
  EXPECT_TRUE(boundary(std::vector<Classified>{{1, 1, "slipper"}, {2, 1, "slipper"}, {3, 1, "undecided"}}).empty());
  EXPECT_TRUE(boundary(std::vector<Classified>{{1, 1, "croissant"}, {1, 2, "slipper"}}).empty());  // other rows
}

TEST(ReportInlineSvg, HasIdsAndWordsOfItsOwn) {
  Figure figure;
  figure.name = "point-7";
  figure.title = "a < b";
  figure.description = "what";
  const std::string file =
      "<?xml version=\"1.0\"?>\n<svg viewBox=\"0 0 4 3\" "
      "xmlns=\"http://www.w3.org/2000/svg\">\n<title>Gnuplot</title>\n"
      "<desc>Produced by</desc><g id=\"gnuplot_canvas\"><defs><circle id='gpDot' r='1'/></defs>\n"
      "<use xlink:href='#gpDot'/><g fill=\"none\" color=\"black\"></g><text>kept</text></g></svg>\n";
  const std::string svg = inline_svg(figure, file).value();
  EXPECT_THAT(svg,
              AllOf(HasSubstr("viewBox=\"0 0 4 3\""), HasSubstr("<title>a &lt; b</title>"), HasSubstr("kept"),
                    HasSubstr("id='point-7-gpDot'"), HasSubstr("href='#point-7-gpDot'"), HasSubstr("role=\"img\"")));
  EXPECT_THAT(svg, AllOf(Not(HasSubstr("http")), Not(HasSubstr("xlink")), Not(HasSubstr("Gnuplot")),
                         Not(HasSubstr("gnuplot_"))));
}

TEST(ReportInlineSvg, RefusesHalfAPicture) {
  EXPECT_FALSE(inline_svg(Figure{}, "").has_value());
  EXPECT_FALSE(inline_svg(Figure{}, "<svg viewBox=\"0 0 1 1\"><g>").has_value());
}

}  // namespace
}  // namespace rouleau::campaign
