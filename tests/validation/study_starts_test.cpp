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

/// The study files beside which the start of their first point is kept: NAME.ini with NAME.start.csv.
std::vector<std::filesystem::path> studies_with_starts() {
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(STUDIES)) {
    const std::string name = entry.path().filename().string();
    if (const auto end = name.find(".start.csv"); end != std::string::npos)
      found.push_back(entry.path().parent_path() / (name.substr(0, end) + ".ini"));
  }
  std::sort(found.begin(), found.end());
  return found;
}

Series kept_start_of(std::filesystem::path study) { return series_of(study.replace_extension(".start.csv")); }

/// The first point of the study, run for `end_time_s`.   returns its directory
/// The end time is a free parameter: the run is the same as far as it goes.
std::filesystem::path run_first_point(const CampaignProgram& program, const std::filesystem::path& study,
                                      double end_time_s) {
  const auto made = program.rouleau({"init", study.string(), "c", "--quiet"});
  EXPECT_EQ(made.status, 0) << made.err;
  std::filesystem::path run = program.campaign() / "points" / program.store().points().front().key;

  std::ostringstream end;
  end << "end_time_s = " << end_time_s;
  const std::string whole = content_of(run / "run.ini");
  set_content(run / "run.ini", std::regex_replace(whole, std::regex("end_time_s = [^\n]*"), end.str()));
  const Finished finished = run_program({REAL_SOLVER_PROGRAM, (run / "run.ini").string(), "--quiet"});
  EXPECT_EQ(finished.code, 0) << finished.err;
  return run;
}

void expect_start(const std::filesystem::path& run, const Series& kept) {
  const Series ours = series_of(run / "samples.csv");
  for (const auto& [column, values] : kept) {
    ASSERT_EQ(ours.count(column), 1U) << column;
    ASSERT_GE(ours.at(column).size(), values.size()) << column;
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_NEAR(ours.at(column)[i], values[i], 1e-5 * std::max(1.0, std::abs(values[i]))) << column << ' ' << i;
  }
}

/// Just beyond the last kept sample.
double end_of(const Series& kept) { return 1.0001 * kept.at("time_s").back(); }

bool starts_from_a_checkpoint(const std::filesystem::path& study) {
  return content_of(study).find("shape = checkpoint") != std::string::npos;
}

TEST(StudyStarts, AreWhatTheStudiesKeep) {
  ASSERT_FALSE(studies_with_starts().empty());
  for (const std::filesystem::path& study : studies_with_starts()) {
    if (starts_from_a_checkpoint(study)) continue;  // the next test
    SCOPED_TRACE(study);
    const Series kept = kept_start_of(study);
    const CampaignProgram program(REAL_SOLVER_PROGRAM);
    expect_start(run_first_point(program, study, end_of(kept)), kept);
  }
}

// A branch of the hysteresis needs a neighbour's cell. Here it is the one of slipper-boundary, 1 ms after its release.
TEST(StudyStarts, OfABranchFollowTheCellOfACheckpoint) {
  const std::filesystem::path first = std::filesystem::path(STUDIES) / "slipper-boundary" / "study.ini";
  std::filesystem::path checkpoint;
  const CampaignProgram neighbour(REAL_SOLVER_PROGRAM);
  for (const auto& entry : std::filesystem::directory_iterator(run_first_point(neighbour, first, 1e-3) / "checkpoints"))
    if (entry.path().extension() == ".h5") checkpoint = std::max(checkpoint, entry.path());

  int branches = 0;
  for (const std::filesystem::path& study : studies_with_starts()) {
    if (!starts_from_a_checkpoint(study)) continue;
    SCOPED_TRACE(study);
    ++branches;
    const Series kept = kept_start_of(study);
    const CampaignProgram program(REAL_SOLVER_PROGRAM);
    // Only the branch's first point: the others' cells are not made yet.
    const std::regex values_after_the_first(R"(((fluid\.lambda|cell\.mesh_file) = [^,\n]*),[^\n]*)");
    set_content(program.study(), std::regex_replace(content_of(study), values_after_the_first, "$1"));
    std::filesystem::copy_file(checkpoint, program.path() / "0.h5");
    expect_start(run_first_point(program, program.study(), end_of(kept)), kept);
  }
  EXPECT_GT(branches, 0);
}

}  // namespace
}  // namespace rouleau::testing
