// SPDX-License-Identifier: BSD-3-Clause
// The power goes at any file-system call, and with it all that was not synced: files, names, renames. Started again,
// run and campaign end as if nothing had been, and no generation that was committed is missing.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <functional>

#include "crash/faults/busy_run.hpp"
#include "crash/faults/busy_study.hpp"
#include "crash/faults/plan.hpp"
#include "support/campaign_outcome.hpp"
#include "support/fault_shim/disk_model.hpp"

namespace rouleau::testing {
namespace {

struct PowerLoss {
  Loss loss;
  std::uint64_t seed;  ///< of a mixed one
  const char* name;
};

constexpr std::array<PowerLoss, 3> whole_losses = {{{Loss::all_pending, 0, "all that was not synced"},
                                                    {Loss::data, 0, "data that was not synced"},
                                                    {Loss::names, 0, "names that were not synced"}}};
constexpr PowerLoss mixed_loss{Loss::mixed, 0, "some of what was not synced"};

/// What is lost at the n-th place that is looked at: in the short form one of the whole losses and a mixed one.
std::vector<PowerLoss> losses_at(std::size_t turn) {
  std::vector<PowerLoss> losses(whole_losses.begin(), whole_losses.end());
  if (!is_long_form()) losses = {whole_losses[turn % whole_losses.size()]};
  const std::size_t seeds = is_long_form() ? 2 : 1;
  for (std::size_t i = 0; i < seeds; ++i) {
    losses.push_back(mixed_loss);
    losses.back().seed = seeds * turn + i;
  }
  return losses;
}

/// Calls `examine` for losses before the first and behind each of the calls: a sample of them in the short form.
void for_each_loss(DiskModel& model, const std::vector<RecordedCall>& calls, std::int64_t sample,
                   const std::function<void(const PowerLoss& loss, std::int64_t call)>& examine) {
  std::size_t applied = 0, turn = 0;
  for (const std::int64_t place : planned_places(static_cast<std::int64_t>(calls.size()) + 1, sample)) {
    while (applied < static_cast<std::size_t>(place - 1)) model.apply(calls[applied++]);
    for (const PowerLoss& loss : losses_at(turn++)) {
      SCOPED_TRACE(fmt::format("{} lost behind call {} of {}, seed {}", loss.name, place - 1, calls.size(), loss.seed));
      ++tally().power_losses;
      examine(loss, place - 1);
      if (::testing::Test::HasFailure() && !is_long_form()) return;
    }
  }
}

/// The newest generation that was committed (renamed, and its directory synced) within the first `count` calls; "" if
/// there is none.
std::string newest_committed(const std::vector<RecordedCall>& calls, std::int64_t count) {
  std::string renamed, committed;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    if (calls[i].name == "rename" && calls[i].other.ends_with(".h5")) {
      renamed = "checkpoints/" + std::filesystem::path(calls[i].other).filename().string();
    }
    if (calls[i].name == "fsync" && calls[i].path.ends_with("/checkpoints")) committed = renamed;
  }
  return committed;
}

void expect_survival(int ranks, std::int64_t sample) {
  const BusyRun undisturbed;
  DiskModel model(undisturbed.directory());
  const std::vector<RecordedCall> calls = recorded(undisturbed, ranks);
  const std::string end = undisturbed.fingerprint();
  for_each_loss(model, calls, sample, [&](const PowerLoss& loss, std::int64_t call) {
    const BusyRun run;
    model.restore(loss.loss, run.directory(), loss.seed);
    run.finish(ranks);
    const nlohmann::json record = run.exit_record();
    if (!record.at("rejected_checkpoints").empty()) ++tally().wrong_resumes;
    EXPECT_TRUE(record.at("rejected_checkpoints").empty()) << record;
    EXPECT_GE(record.at("resumed_from").get<std::string>(), newest_committed(calls, call));
    const std::string found = run.fingerprint();
    if (found != end) ++tally().lost_samples;
    EXPECT_EQ(found, end);
  });
}

TEST(PowerLoss, AtAnyCallLosesNoCommittedGeneration) { expect_survival(1, 12); }
TEST(PowerLoss, AtAnyCallOfTwoRanksLosesNoCommittedGeneration) { expect_survival(2, 3); }

TEST(PowerLoss, AtAnyCallOfManagerAndSolversLeavesNoTraceInTheCampaign) {
  const CampaignProgram undisturbed(ROULEAU_SOLVER);
  set_content(undisturbed.study(), busy_study(48));
  DiskModel model(undisturbed.path());
  std::vector<RecordedCall> calls;
  std::int64_t calls_of_init = 0;
  {
    Faults faults(undisturbed.path(), "", {});
    faults.record();
    const auto made = undisturbed.init();
    ASSERT_EQ(made.status, 0) << made.err;
    calls_of_init = faults.calls();
    const auto run = undisturbed.run();
    ASSERT_EQ(run.status, 0) << run.err;
    calls = read_calls(faults.log());
  }
  const CampaignOutcome end = outcome_of(undisturbed);
  for_each_loss(model, calls, 9, [&](const PowerLoss& loss, std::int64_t call) {
    const CampaignProgram program(ROULEAU_SOLVER);
    model.restore(loss.loss, program.path(), loss.seed);
    if (call < calls_of_init) {
      const auto made = program.init();
      EXPECT_EQ(made.status, 0) << made.err;
    }
    const auto run = program.run();
    EXPECT_EQ(run.status, 0) << run.err;
    tally().manual_steps += run.status != 0 ? 1 : 0;
    const CampaignOutcome found = outcome_of(program);
    if (found.logs != end.logs) ++tally().lost_samples;
    EXPECT_EQ(found, end);
    const auto check = program.rouleau({"verify", "c", "--checkpoints"});
    EXPECT_EQ(check.status, 0) << check.out << check.err;
  });
}

}  // namespace
}  // namespace rouleau::testing
