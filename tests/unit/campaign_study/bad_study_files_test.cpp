// SPDX-License-Identifier: BSD-3-Clause
// A table of wrong study files, each with what its one-line error must say.
#include <gmock/gmock.h>

#include "study/error.hpp"
#include "study/expand.hpp"
#include "study/study.hpp"

namespace rouleau::campaign {
namespace {

struct Bad {
  const char* what;                ///< names the case
  std::string text;                ///< behind "[study]\nname = s\n" unless it has its own [study]
  std::vector<std::string> parts;  ///< of the message
};

const std::vector<Bad> bad_studies = {
    {"NoName", "[study]\n[fluid]\nlambda = 5\n", {"study.ini: has no name", "[study]"}},
    {"UnknownStudyEntry", "[study]\nnam = s\n", {"study.ini:2:", "`nam`", "Did you mean `name`?"}},
    {"NameWithBlanks", "[study]\nname = a b\n", {"study.ini:2:", "a b", "plain name"}},
    {"NameWithSlash", "[study]\nname = ../x\n", {"study.ini:2:", "plain name"}},
    {"NameTooLong", "[study]\nname = " + std::string(101, 'a'), {"study.ini:2:", "101 letters", "at most 100"}},
    {"NoSection", "lambda = 5\n[study]\nname = s\n", {"study.ini:1:", "before the first section"}},
    {"NeitherSectionNorEntry", "[fluid]\nlambda 5\n", {"study.ini:4:", "`lambda 5`", "name = value"}},
    {"OpenBracket", "[fluid\nlambda = 5\n", {"study.ini:3:", "`[fluid`", "[name]"}},
    {"EmptySectionName", "[]\nlambda = 5\n", {"study.ini:3:", "`[]`"}},
    {"NoEntryName", "[fluid]\n= 5\n", {"study.ini:4:", "no name"}},
    {"NoValue", "[fluid]\nlambda =\n", {"study.ini:4:", "`lambda` has no value"}},
    {"ValueIsComment", "[fluid]\nlambda = # five\n", {"study.ini:4:", "`lambda` has no value"}},
    {"Duplicate", "[fluid]\nlambda = 5\nlambda = 6\n", {"study.ini:5:", "`lambda`", "line 4"}},
    {"DuplicateInReopenedSection",
     "[fluid]\nlambda = 5\n[cell]\nradius_um = 4\n[fluid]\nlambda = 5\n",
     {"study.ini:8:", "line 4"}},
    {"MistypedSection", "[sweeep]\nfluid.lambda = 1\n", {"study.ini:4:", "[sweeep]", "Did you mean [sweep]?"}},
    {"MistypedExecution", "[excution]\njobs = 1\n", {"study.ini:4:", "Did you mean [execution]?"}},
    {"UnknownSweepEntry", "[sweep]\nlambda = 1, 2\n", {"study.ini:4:", "`lambda`", "fluid.lambda = 1, 2"}},
    {"MistypedReplicas", "[sweep]\nreplica = 2\n", {"study.ini:4:", "Did you mean `replicas`?"}},
    {"UnknownMode", "[sweep]\nmode = zipp\n", {"study.ini:4:", "mode = zipp", "Did you mean `zip`?"}},
    {"EmptyPlaceInList", "[sweep]\nfluid.lambda = 1,,2\n", {"study.ini:4:", "empty place"}},
    {"TrailingComma", "[sweep]\nfluid.lambda = 1, 2,\n", {"study.ini:4:", "empty place"}},
    {"RangeWithoutStep", "[sweep]\nfluid.lambda = 4:5\n", {"study.ini:4:", "`4:5`", "from:to:step"}},
    {"RangeOfFour", "[sweep]\nfluid.lambda = 4:5:1:2\n", {"study.ini:4:", "from:to:step"}},
    {"RangeStepZero", "[sweep]\nfluid.lambda = 4:5:0\n", {"study.ini:4:", "step is 0"}},
    {"RangeWrongWay", "[sweep]\nfluid.lambda = 4:5:-1\n", {"study.ini:4:", "leads away from 5"}},
    {"RangeWithWord", "[sweep]\nfluid.lambda = 4:five:1\n", {"study.ini:4:", "`five` is not a number"}},
    {"RangeTooLong", "[sweep]\nfluid.lambda = 0:1:0.000001\n", {"study.ini:4:", "more than 100000 values"}},
    {"AxisOfTooManyRanges",
     "[sweep]\nfluid.lambda = 1:60000:1, 1:60000:1, 1\n",
     {"study.ini:4:", "more than 100000 values"}},
    {"SweepTooLarge", "[sweep]\na.x = 1:1000:1\na.y = 1:1000:1\n", {"study.ini: ", "1000000 points", "100000"}},
    {"FixedAndSwept",
     "[fluid]\nlambda = 5\n[sweep]\nfluid.lambda = 1, 2\n",
     {"study.ini:6:", "fluid.lambda", "line 4"}},
    {"ZipOfUnequalAxes",
     "[sweep]\nmode = zip\na.x = 1, 2\na.y = 1, 2, 3\n",
     {"study.ini:6:", "3 values", "a.x (line 5) has 2"}},
    {"ReplicasWithoutJitter", "[sweep]\nreplicas = 3\n", {"study.ini:4:", "replicas = 3", "jitter_um above 0"}},
    {"ReplicasWithZeroJitter", "[cell]\njitter_um = 0\n[sweep]\nreplicas = 3\n", {"study.ini:6:", "jitter_um"}},
    {"ReplicasAndReplica", "[cell]\njitter_um = 1\nreplica = 1\n[sweep]\nreplicas = 3\n", {"cell.replica", "already"}},
    {"ReplicasNotWhole",
     "[cell]\njitter_um = 1\n[sweep]\nreplicas = 2.5\n",
     {"study.ini:6:", "replicas = 2.5", "whole number from 1"}},
    {"UnknownEngine", "[execution]\nengine = locl\n", {"study.ini:4:", "engine = locl", "Did you mean `local`?"}},
    {"UnknownExecutionEntry", "[execution]\njob = 2\n", {"study.ini:4:", "`job`", "Did you mean `jobs`?"}},
    {"JobsNotANumber", "[execution]\njobs = two\n", {"study.ini:4:", "jobs = two is not a number"}},
    {"JobsNegative", "[execution]\njobs = -1\n", {"study.ini:4:", "jobs = -1 is out of range", "0 to 1024"}},
    {"RanksZero", "[execution]\nranks = 0\n", {"study.ini:4:", "ranks = 0", "from 1 to"}},
    {"RanksNotWhole", "[execution]\nranks = 1.5\n", {"study.ini:4:", "whole number"}},
    {"NicenessTooHigh", "[execution]\nniceness = 20\n", {"study.ini:4:", "from 0 to 19"}},
    {"CheckpointIntervalTwice",
     "[output]\ncheckpoint_interval_min = 1\n[execution]\ncheckpoint_interval_min = 2\n",
     {"study.ini:6:", "output.checkpoint_interval_min", "line 4"}},
    {"UnknownAnalysisEntry", "[analysis]\nwindow = 1\n", {"study.ini:4:", "`window`", "window_s"}},
    {"WindowZero", "[analysis]\nwindow_s = 0\n", {"study.ini:4:", "window_s = 0 is out of range"}},
    {"MeshFileMissing", "[cell]\nmesh_file = nowhere.off\n", {"study.ini:4:", "nowhere.off", "study file's directory"}},
    {"SweptMeshFileMissing", "[sweep]\ncell.mesh_file = nowhere.off\n", {"study.ini:4:", "nowhere.off"}},
};

class BadStudy : public testing::TestWithParam<Bad> {};

TEST_P(BadStudy, IsRefusedInOneClearLine) {
  const Bad& bad = GetParam();
  const std::string own = bad.text;
  const bool has_study = own.find("[study]") != std::string::npos;
  const auto nothing_runs = [](const std::string&) -> CheckOutcome { return {{}, "must not get here"}; };
  try {
    const Study study = parse_study(has_study ? own : "[study]\nname = s\n" + own, "study.ini");
    static_cast<void>(expand(study, nothing_runs));
    FAIL() << "was taken";
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_EQ(error.code(), Exit::usage);
    EXPECT_EQ(message.find('\n'), std::string::npos) << "one line: " << message;
    for (const std::string& part : bad.parts) EXPECT_THAT(message, testing::HasSubstr(part));
  }
}

INSTANTIATE_TEST_SUITE_P(Table, BadStudy, testing::ValuesIn(bad_studies),
                         [](const testing::TestParamInfo<Bad>& bad) { return std::string(bad.param.what); });

}  // namespace
}  // namespace rouleau::campaign
