// SPDX-License-Identifier: BSD-3-Clause
// share/examples on exported files: their numbers are those of `rouleau query`, their picture has the points.
#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "../../unit/campaign_ingest/written_campaign.hpp"
#include "commands/verbs.hpp"
#include "executor/capture.hpp"

namespace rouleau::campaign {
namespace {

using ::rouleau::testing::content_of;
using ::rouleau::testing::set_content;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::log_header;
using testing::log_line;
using testing::log_lines;

/// λ = 1 stays near the axis, λ = 4 between, λ = 5 and 6 far from it, λ = 9 has not run.
class ExamplesTest : public ::testing::Test {
 protected:
  ExamplesTest() {
    for (const int lambda : {1, 4, 5, 6, 9}) campaign_.add_point(lambda);
    set_content(campaign_.log("000000abc001"), log_header + steady(0.05));
    set_content(campaign_.log("000000abc004"), log_header + steady(0.4));
    set_content(campaign_.log("000000abc005"), log_header + log_lines(0, 100000));
    set_content(campaign_.log("000000abc006"), log_header + steady(1.2));
    EXPECT_EQ(call({"rebuild", campaign_.path()}).first, 0);
  }

  /// Samples that go up and down a little about d.
  static std::string steady(double d) {
    std::string text;
    for (std::int64_t step = 0; step <= 100000; step += 100)
      text += log_line(step, fmt::format("{}", d + 0.01 * std::sin(static_cast<double>(step))));
    return text;
  }

  /// `rouleau WORDS`: exit code and stdout.
  static std::pair<int, std::string> call(const std::vector<std::string>& words) {
    std::ostringstream out, err;
    Streams io{out, err};
    const int code = run_command_line(all_verbs, words, io);
    EXPECT_EQ(err.str().find("cannot"), std::string::npos) << err.str();
    return {code, out.str()};
  }

  [[nodiscard]] nlohmann::json phase_table(std::vector<std::string> options) const {
    options.insert(options.begin(),
                   {"query", campaign_.path(), "--where", "d_mean_um is not null", "--format", "json"});
    return nlohmann::json::parse(call(options).second)["rows"];
  }

  [[nodiscard]] std::string file(const std::string& name) const { return (place_.path() / name).string(); }

  testing::WrittenCampaign campaign_;
  ::rouleau::testing::TemporaryDirectory place_;
};

struct Line {
  double lambda = 0, d_um = 0;
  std::string phase;
};

std::vector<Line> lines_of(const std::string& printed) {
  std::istringstream in(printed);
  std::vector<Line> lines;
  std::string text;
  std::getline(in, text);  // the heading
  while (std::getline(in, text)) {
    std::istringstream words(text);
    Line line;
    words >> line.lambda >> line.phase >> line.d_um;
    lines.push_back(line);
  }
  return lines;
}

TEST_F(ExamplesTest, PythonAveragesTheSeriesToTheNumbersOfTheQuery) {
  ASSERT_EQ(call({"export", campaign_.path(), "--format", "sqlite", "-o", file("c.sqlite")}).first, 0);
  const std::vector<std::string> command = {"python3", EXAMPLES "/phase_diagram.py", file("c.sqlite")};
  std::vector<std::string> wider = command;
  wider.push_back("0.3");
  const std::pair<std::vector<std::string>, nlohmann::json> cases[] = {{command, phase_table({})},
                                                                       {wider, phase_table({"--window", "0.3"})}};
  for (const auto& [words, wanted] : cases) {
    const Capture printed = run_and_capture(words);
    ASSERT_EQ(printed.status, 0) << printed.err;
    const std::vector<Line> lines = lines_of(printed.out);
    ASSERT_EQ(lines.size(), wanted.size()) << printed.out;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      EXPECT_EQ(lines[i].lambda, wanted[i]["lambda"]);
      EXPECT_NEAR(lines[i].d_um, wanted[i]["d_mean_um"], 5.1e-7);  // six decimals are printed
    }
  }
  const std::vector<Line> lines = lines_of(run_and_capture(command).out);
  const nlohmann::json wanted = phase_table({});
  for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_EQ(lines[i].phase, wanted[i]["class"]);
}

/// How often each sign of a class is drawn: by the id of its shape in gnuplot's SVG, in the colours that are not white.
std::map<std::string, int> signs_in(const std::string& svg) {
  std::map<std::string, int> signs;
  std::istringstream in(svg);
  const std::string begin = "<use xlink:href='#";
  for (std::string line; std::getline(in, line);) {
    const std::size_t place = line.find(begin);
    if (place == std::string::npos || line.find("color='rgb") == std::string::npos) continue;
    const std::size_t name = place + begin.size();
    ++signs[line.substr(name, line.find('\'', name) - name)];
  }
  return signs;
}

TEST_F(ExamplesTest, GnuplotDrawsEveryPointWithTheSignOfItsClass) {
  ASSERT_EQ(call({"export", campaign_.path(), "-o", file("points.csv")}).first, 0);
  const Capture drawn =
      run_and_capture({"gnuplot", "-c", EXAMPLES "/phase_diagram.gp", file("points.csv"), file("p.svg")});
  ASSERT_EQ(drawn.status, 0) << drawn.err;
  EXPECT_EQ(drawn.err, "");
  const std::string svg = content_of(file("p.svg"));
  EXPECT_THAT(svg, AllOf(HasSubstr("croissant"), HasSubstr("slipper"), HasSubstr("undecided"), HasSubstr("λ")));
  std::map<std::string, int> wanted;  // and each once more in the key
  for (const nlohmann::json& row : phase_table({}))
    wanted[row["class"] == "croissant" ? "gpPt4" : row["class"] == "slipper" ? "gpPt6" : "gpPt8"] += 1;
  for (auto& [sign, count] : wanted) ++count;
  EXPECT_EQ(wanted.size(), 3U);
  EXPECT_EQ(signs_in(svg), wanted);
  const Capture parsed =
      run_and_capture({"python3", "-c", "import sys, xml.dom.minidom as x; x.parse(sys.argv[1])", file("p.svg")});
  EXPECT_EQ(parsed.status, 0) << parsed.err;
}

TEST_F(ExamplesTest, GnuplotDrawsAlsoWhenClassesAreMissing) {
  ASSERT_EQ(call({"export", campaign_.path(), "--where", "class = slipper", "-o", file("points.csv")}).first, 0);
  const Capture drawn =
      run_and_capture({"gnuplot", "-c", EXAMPLES "/phase_diagram.gp", file("points.csv"), file("p.svg")});
  EXPECT_EQ(drawn.status, 0) << drawn.err;
  EXPECT_EQ(signs_in(content_of(file("p.svg")))["gpPt6"], 3);  // two and the key's
}

}  // namespace
}  // namespace rouleau::campaign
