// SPDX-License-Identifier: BSD-3-Clause
// Every file-system call of the real solver fails or kills it, one after the other; started again, it ends as if
// nothing had been.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "crash/faults/busy_run.hpp"
#include "crash/faults/plan.hpp"
#include "support/fault_shim/disk_model.hpp"

namespace rouleau::testing {
namespace {

void expect_clear_message(const Injection& injection, const Finished& finished) {
  EXPECT_EQ(finished.code, 74) << finished.err;
  EXPECT_NE(finished.err.find(fmt::format("(errno {})", injection.error_number)), std::string::npos) << finished.err;
  if (injection.error_number != EIO) {
    EXPECT_NE(finished.err.find("Free space or raise the quota"), std::string::npos) << finished.err;
  }
}

/// Runs with the fault; checks how that ended.   returns whether the call was reached
bool disturb(const BusyRun& run, int ranks, const Injection& injection) {
  const Faults faults(run.directory(), solver_program, injection);
  const Finished finished = run.run(ranks);
  if (faults.injected() == 0) {
    EXPECT_EQ(finished.code, 0) << finished.err;
    return false;
  }
  count(injection);
  switch (injection.fault) {
    case Fault::error:
      // What is no use to the run any more (a descriptor that was read, the exit record of a finished run) ends
      // nothing.
      if (finished.code != 0) expect_clear_message(injection, finished);
      break;
    case Fault::brief:
      EXPECT_EQ(finished.code, 0) << finished.err;
      break;
    default:
      EXPECT_NE(finished.code, 0);
  }
  return true;
}

/// Goes on without faults; expects the end of an undisturbed run, and that nothing on the disk was taken for damaged.
void expect_undisturbed_end(const BusyRun& run, int ranks, const std::string& end) {
  run.finish(ranks);
  const nlohmann::json record = run.exit_record();
  if (!record.at("rejected_checkpoints").empty()) ++tally().wrong_resumes;
  EXPECT_TRUE(record.at("rejected_checkpoints").empty()) << record;
  const std::string found = run.fingerprint();
  if (found != end) ++tally().lost_samples;
  EXPECT_EQ(found, end);
}

void expect_no_trace_of_faults(int ranks, int sample) {
  const BusyRun undisturbed;
  const std::vector<RecordedCall> calls = recorded(undisturbed, ranks);
  const std::string end = undisturbed.fingerprint();
  fmt::print("{} calls on {} ranks\n", calls.size(), ranks);
  int reached = 0;
  for (const Injection& injection : planned_faults(calls, sample)) {
    SCOPED_TRACE(fmt::format("{} at call {} of {}", name_of(injection), injection.at, calls.size()));
    const BusyRun run;
    if (disturb(run, ranks, injection)) ++reached;
    expect_undisturbed_end(run, ranks, end);
    if (::testing::Test::HasFailure() && !is_long_form()) return;
  }
  EXPECT_GT(reached, 0);
}

TEST(FaultShim, SeesEveryChangeOfTheSolver) {
  const BusyRun run;
  DiskModel model(run.directory());
  for (const RecordedCall& call : recorded(run, 2)) model.apply(call);
  for (const auto& [name, content] : model.files()) EXPECT_EQ(content, content_of(run.path(name))) << name;
  std::size_t found = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(run.directory())) {
    if (entry.is_regular_file()) ++found;
  }
  EXPECT_EQ(found, model.files().size());
}

TEST(SolverFaults, AtAnyCallLeaveNoTraceOnOneRank) { expect_no_trace_of_faults(1, 14); }
TEST(SolverFaults, AtAnyCallLeaveNoTraceOnTwoRanks) { expect_no_trace_of_faults(2, 4); }

}  // namespace
}  // namespace rouleau::testing
