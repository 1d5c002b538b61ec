// SPDX-License-Identifier: BSD-3-Clause
// The studies with results still give them: the first samples of the first point of each, run again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <regex>
#include <sstream>

#include "support/campaign_program.hpp"
#include "support/process.hpp"

namespace rouleau::testing {
namespace {

using Series = std::map<std::string, std::vector<double>>;

/// samples.csv by column, without the checks.
Series series_of(const std::filesystem::path& file) {
  std::istringstream lines(content_of(file));
  std::string line, name, value;
  std::getline(lines, line);
  std::istringstream header(line);
  std::vector<std::string> names;
  while (std::getline(header, name, ',')) names.push_back(name);
  Series series;
  while (std::getline(lines, line)) {
    std::istringstream row(line);
    for (const std::string& each : names)
      if (std::getline(row, value, ',') && each != "check") series[each].push_back(std::stod(value));
  }
  return series;
}

/// The studies that keep the start of their first point.
std::vector<std::filesystem::path> studies() {
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::directory_iterator(STUDIES))
    if (std::filesystem::exists(entry.path() / "start.csv")) found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

TEST(StudyStarts, AreWhatTheStudiesKeep) {
  ASSERT_FALSE(studies().empty());
  for (const std::filesystem::path& study : studies()) {
    SCOPED_TRACE(study.filename());
    const Series kept = series_of(study / "start.csv");
    const CampaignProgram program(REAL_SOLVER_PROGRAM);
    const auto made = program.rouleau({"init", (study / "study.ini").string(), "c", "--quiet"});
    ASSERT_EQ(made.status, 0) << made.err;
    const std::string key = program.store().points().front().key;
    const std::filesystem::path run = program.campaign() / "points" / key;

    // As far as the kept samples go. The end time is a free parameter: the run is the same so far.
    std::ostringstream end;
    end << "end_time_s = " << 1.0001 * kept.at("time_s").back();
    const std::string whole = content_of(run / "run.ini");
    set_content(run / "run.ini", std::regex_replace(whole, std::regex("end_time_s = [^\n]*"), end.str()));
    const Finished finished = run_program({REAL_SOLVER_PROGRAM, (run / "run.ini").string(), "--quiet"});
    ASSERT_EQ(finished.code, 0) << finished.err;

    const Series ours = series_of(run / "samples.csv");
    for (const auto& [column, values] : kept) {
      ASSERT_EQ(ours.count(column), 1U) << column;
      ASSERT_GE(ours.at(column).size(), values.size()) << column;
      for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_NEAR(ours.at(column)[i], values[i], 1e-5 * std::max(1.0, std::abs(values[i]))) << column << ' ' << i;
    }
  }
}

}  // namespace
}  // namespace rouleau::testing
