// SPDX-License-Identifier: BSD-3-Clause
// A table of what squeue shows and what it means for a job.
#include "jobs/slurm_state.hpp"

#include <gmock/gmock.h>

#include <vector>

namespace rouleau::campaign {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct Shown {
  const char* state;
  const char* reason;
  Phase phase;
  Cause cause;
  const char* words;  ///< part of them
};

// Reasons as printed by Slurm 22.05 (squeue %r); those of its library that name a limit are covered by the rules below.
const std::vector<Shown> table = {
    {"PENDING", "Priority", Phase::pending, Cause::none, "queued (waits for its turn: Priority)"},
    {"PENDING", "Resources", Phase::pending, Cause::none, "free nodes"},
    {"PENDING", "None", Phase::pending, Cause::none, "queued"},
    {"PENDING", "", Phase::pending, Cause::none, "queued"},
    {"PENDING", "(null)", Phase::pending, Cause::none, "queued"},
    {"PENDING", "BeginTime", Phase::pending, Cause::none, "put back into the queue"},
    {"PENDING", "Dependency", Phase::pending, Cause::none, "another job"},
    {"PENDING", "ReqNodeNotAvail", Phase::pending, Cause::none, "down, drained or reserved"},
    {"PENDING", "ReqNodeNotAvail, UnavailableNodes:n[1-2]", Phase::pending, Cause::none, "UnavailableNodes:n[1-2]"},
    {"PENDING", "(ReqNodeNotAvail, May be reserved for other job)", Phase::pending, Cause::none, "reserved"},
    {"PENDING", "Nodes required for job are DOWN, DRAINED or reserved for jobs in higher priority partitions",
     Phase::pending, Cause::none, "waits for nodes that are down"},
    {"PENDING", "Reservation", Phase::pending, Cause::none, "its reservation"},
    {"PENDING", "PartitionDown", Phase::pending, Cause::none, "partition"},
    {"PENDING", "PartitionInactive", Phase::pending, Cause::none, "partition"},
    {"PENDING", "NodeDown", Phase::pending, Cause::none, "down"},
    {"PENDING", "Licenses", Phase::pending, Cause::none, "licences"},
    {"PENDING", "QOSMaxJobsPerUserLimit", Phase::pending, Cause::none, "QOSMaxJobsPerUserLimit"},
    {"PENDING", "QOSMaxCpuPerUserLimit", Phase::pending, Cause::none, "QOSMaxCpuPerUserLimit"},
    {"PENDING", "QOSMaxNodePerUserLimit", Phase::pending, Cause::none, "QOSMaxNodePerUserLimit"},
    {"PENDING", "QOSMaxMemoryPerUser", Phase::pending, Cause::none, "QOSMaxMemoryPerUser"},
    {"PENDING", "MaxCpuPerAccount", Phase::pending, Cause::none, "MaxCpuPerAccount"},
    {"PENDING", "AssocGrpCPUMinutesLimit", Phase::pending, Cause::none, "AssocGrpCPUMinutesLimit"},
    {"PENDING", "AssocGrpNodeLimit", Phase::pending, Cause::none, "AssocGrpNodeLimit"},
    {"PENDING", "QOSGrpCpuLimit", Phase::pending, Cause::none, "QOSGrpCpuLimit"},
    {"PENDING", "AssocMaxJobsLimit", Phase::pending, Cause::none, "AssocMaxJobsLimit"},
    {"PENDING", "NonZeroExitCode", Phase::pending, Cause::none, "started again"},
    {"PENDING", "SomethingNew, with (brackets) | and bars", Phase::pending, Cause::none,
     "queued (waits: SomethingNew, with (brackets) | and bars)"},

    {"PENDING", "JobHeldUser", Phase::held, Cause::none, "held (by its owner: JobHeldUser)"},
    {"PENDING", "JobHeldAdmin", Phase::held, Cause::none, "administrator"},
    {"PENDING", "launch failed requeued held", Phase::held, Cause::launch, "failed to launch"},
    {"PENDING", "launch_failed_requeued_held", Phase::held, Cause::launch, "failed to launch"},
    {"PENDING", "(launch failed requeued held)", Phase::held, Cause::launch, "failed to launch"},
    {"PENDING", "JobHoldMaxRequeue", Phase::held, Cause::launch, "too many"},
    {"PENDING", "job requeued in held state", Phase::held, Cause::unclear, "put back"},
    {"PENDING", "ReservationDeleted", Phase::held, Cause::none, "reservation"},
    {"REQUEUE_HOLD", "JobHeldAdmin", Phase::held, Cause::none, "administrator"},
    {"REQUEUE_HOLD", "None", Phase::held, Cause::unclear, "held"},
    {"REQUEUE_HOLD", "launch failed requeued held", Phase::held, Cause::launch, "launch"},
    {"SPECIAL_EXIT", "job requeued in held state", Phase::held, Cause::unclear, "held"},
    {"RESV_DEL_HOLD", "None", Phase::held, Cause::none, "reservation"},
    {"LAUNCH_FAILED", "None", Phase::held, Cause::launch, "launch"},
    {"RECONFIG_FAIL", "None", Phase::held, Cause::launch, "launch"},

    {"PENDING", "PartitionConfig", Phase::impossible, Cause::launch, "can never start"},
    {"PENDING", "PartitionNodeLimit", Phase::impossible, Cause::launch, "nodes"},
    {"PENDING", "PartitionTimeLimit", Phase::impossible, Cause::launch, "time limit"},
    {"PENDING", "BadConstraints", Phase::impossible, Cause::launch, "constraints"},
    {"PENDING", "DependencyNeverSatisfied", Phase::impossible, Cause::launch, "failed"},
    {"PENDING", "InvalidAccount", Phase::impossible, Cause::launch, "account"},
    {"PENDING", "InvalidQOS", Phase::impossible, Cause::launch, "quality of service"},
    {"PENDING", "AccountNotAllowed", Phase::impossible, Cause::launch, "account"},
    {"PENDING", "QOSNotAllowed", Phase::impossible, Cause::launch, "quality of service"},
    {"PENDING", "MaxMemPerLimit", Phase::impossible, Cause::launch, "memory"},
    {"PENDING", "QOSMaxCpuPerJobLimit", Phase::impossible, Cause::launch, "QOSMaxCpuPerJobLimit"},
    {"PENDING", "QOSMaxWallDurationPerJobLimit", Phase::impossible, Cause::launch, "one job"},
    {"PENDING", "QOSMaxNodePerJobLimit", Phase::impossible, Cause::launch, "one job"},
    {"PENDING", "QOSMaxCpuMinutesPerJobLimit", Phase::impossible, Cause::launch, "one job"},
    {"PENDING", "QOSMinCpuNotSatisfied", Phase::impossible, Cause::launch, "QOSMinCpuNotSatisfied"},
    {"PENDING", "QOSMinGRES", Phase::impossible, Cause::launch, "one job"},
    {"PENDING", "AssocMaxCpuPerJobLimit", Phase::impossible, Cause::launch, "one job"},
    {"PENDING", "AssocMaxWallDurationPerJobLimit", Phase::impossible, Cause::launch, "one job"},
    {"PENDING", "AssocMaxMemPerNode", Phase::impossible, Cause::launch, "one job"},
    {"PENDING", "DeadLine", Phase::impossible, Cause::launch, "deadline"},

    {"RUNNING", "None", Phase::running, Cause::none, "running on n1"},
    {"CONFIGURING", "None", Phase::running, Cause::none, "starting"},
    {"COMPLETING", "None", Phase::running, Cause::none, "ending"},
    {"SUSPENDED", "None", Phase::running, Cause::none, "computes nothing"},
    {"STOPPED", "None", Phase::running, Cause::none, "computes nothing"},
    {"STAGE_OUT", "None", Phase::running, Cause::none, "ending"},
    {"RESIZING", "None", Phase::running, Cause::none, "running"},
    {"SIGNALING", "None", Phase::running, Cause::none, "running"},
    {"REQUEUED", "None", Phase::pending, Cause::none, "queued again"},
    {"REQUEUE_FED", "None", Phase::pending, Cause::none, "queued again"},

    {"COMPLETED", "None", Phase::ended, Cause::none, "ended"},
    {"CANCELLED", "None", Phase::ended, Cause::cancelled, "Slurm: cancelled on n1"},
    {"CANCELLED by 1000", "None", Phase::ended, Cause::cancelled, "cancelled"},
    {"CANCELLED+", "", Phase::ended, Cause::cancelled, "cancelled"},
    {"TIMEOUT", "TimeLimit", Phase::ended, Cause::time_limit, "Slurm: time limit reached on n1"},
    {"DEADLINE", "None", Phase::ended, Cause::time_limit, "deadline"},
    {"OUT_OF_MEMORY", "OutOfMemory", Phase::ended, Cause::memory, "Slurm: out of memory on n1"},
    {"PREEMPTED", "None", Phase::ended, Cause::preempted, "preempted"},
    {"NODE_FAIL", "NodeDown", Phase::ended, Cause::node, "node failure on n1"},
    {"BOOT_FAIL", "None", Phase::ended, Cause::node, "boot"},
    {"FAILED", "NonZeroExitCode", Phase::ended, Cause::unclear, "Slurm: failed: NonZeroExitCode on n1"},
    {"FAILED", "JobLaunchFailure", Phase::ended, Cause::launch, "could not be launched, or its script was killed"},
    {"FAILED", "RaisedSignal:11(Segmentation_fault)", Phase::ended, Cause::unclear, "RaisedSignal:11"},
    {"FAILED", "SystemFailure", Phase::ended, Cause::node, "system"},
    {"FAILED", "OutOfMemory", Phase::ended, Cause::memory, "memory"},
    {"FAILED", "TimeLimit", Phase::ended, Cause::time_limit, "time limit"},
    {"FAILED", "None", Phase::ended, Cause::unclear, "Slurm: failed on n1"},
    {"FAILED", "", Phase::ended, Cause::unclear, "Slurm: failed"},

    {"REVOKED", "None", Phase::running, Cause::unclear, "`REVOKED`, which rouleau does not know"},
    {"TELEPORTED", "Fun", Phase::running, Cause::unclear, "`TELEPORTED`"},
    {"", "", Phase::running, Cause::unclear, "does not know"},
};

TEST(SlurmState, EveryStateAndReasonHasItsMeaning) {
  for (const Shown& shown : table) {
    SCOPED_TRACE(std::string(shown.state) + " | " + shown.reason);
    const JobView view = view_of(shown.state, shown.reason, "n1");
    EXPECT_EQ(view.phase, shown.phase);
    EXPECT_EQ(view.cause, shown.cause);
    EXPECT_THAT(view.words, HasSubstr(shown.words));
  }
}

TEST(SlurmState, UnknownStatesAreNeverAnEnd) {
  for (const char* word : {"DONE", "EXITED", "FAIL", "completed?", "PD", "R", "\xff\xfe", "FAILED_MAYBE"}) {
    EXPECT_EQ(view_of(word, "None", "").phase, Phase::running) << word;
  }
}

TEST(SlurmState, WordsNameNoNodesWhereThereAreNone) {
  EXPECT_EQ(view_of("CANCELLED", "None", "").words, "Slurm: cancelled");
  EXPECT_THAT(view_of("RUNNING", "None", "").words, Not(HasSubstr(" on ")));
}

}  // namespace
}  // namespace rouleau::campaign
