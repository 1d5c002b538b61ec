// SPDX-License-Identifier: BSD-3-Clause
// The life of a job: every rule of the header, and that neither silence nor absence decides anything by itself.
#include "jobs/job_life.hpp"

#include <gmock/gmock.h>

namespace rouleau::campaign {
namespace {

using testing::HasSubstr;

constexpr double patience_s = 900;

/// Of a released job that Slurm shows like this.
JobTrace shown(const char* state, const char* reason = "None") {
  JobTrace trace;
  trace.answered = true;
  trace.job = "4711";
  trace.is_submitted = true;
  trace.is_released = true;
  trace.view = view_of(state, reason, "n1");
  return trace;
}

JobTrace absent(double silent_s) {
  JobTrace trace = shown("RUNNING");
  trace.view.reset();
  trace.silent_s = silent_s;
  return trace;
}

TEST(JobLife, LastWordsOfTheSolverEndTheAttemptWhateverSlurmSays) {
  for (const int code : {0, 65, 70, 76}) {
    for (JobTrace trace :
         {shown("RUNNING"), shown("PENDING", "BeginTime"), shown("COMPLETED"), absent(0), JobTrace{}}) {
      trace.exit_code = code;
      const JobLife life = life_of_job(trace, patience_s);
      EXPECT_EQ(life.life, Life::dead) << code;
      EXPECT_EQ(life.action, JobAction::none) << code;
    }
  }
}

TEST(JobLife, SilentSchedulerChangesNothing) {
  JobTrace trace;
  trace.silent_s = 1e9;
  trace.since_intent_s = 1e9;
  EXPECT_EQ(life_of_job(trace, patience_s).life, Life::alive);
  // It may be pending again, to go on behind this checkpoint.
  trace.exit_code = 75;
  trace.status = 75;
  EXPECT_EQ(life_of_job(trace, patience_s).life, Life::alive);
}

TEST(JobLife, RequeuedJobIsWaitedFor) {
  JobTrace trace = shown("PENDING", "BeginTime");
  trace.exit_code = 75;
  const JobLife life = life_of_job(trace, patience_s);
  EXPECT_EQ(life.life, Life::alive);
  EXPECT_EQ(life.action, JobAction::none);
  EXPECT_THAT(life.words, HasSubstr("behind its checkpoint"));
}

TEST(JobLife, OnlyAHoldOfOursIsReleased) {
  JobTrace trace = shown("PENDING", "JobHeldUser");
  EXPECT_EQ(life_of_job(trace, patience_s).action, JobAction::none);
  EXPECT_EQ(life_of_job(trace, patience_s).life, Life::alive);
  EXPECT_TRUE(life_of_job(trace, patience_s).is_shown);
  trace.is_released = false;
  EXPECT_EQ(life_of_job(trace, patience_s).action, JobAction::release);
  EXPECT_FALSE(life_of_job(trace, patience_s).is_shown);
}

TEST(JobLife, HoldAfterAFailedLaunchIsCancelledAndOver) {
  const JobLife life = life_of_job(shown("PENDING", "launch failed requeued held"), patience_s);
  EXPECT_EQ(life.life, Life::dead);
  EXPECT_EQ(life.cause, Cause::launch);
  EXPECT_EQ(life.action, JobAction::cancel);
  EXPECT_FALSE(life.can_never_start);
}

TEST(JobLife, ImpossibleRequestIsCancelledAndCanNeverStart) {
  const JobLife life = life_of_job(shown("PENDING", "PartitionConfig"), patience_s);
  EXPECT_EQ(life.life, Life::dead);
  EXPECT_EQ(life.action, JobAction::cancel);
  EXPECT_TRUE(life.can_never_start);
}

TEST(JobLife, OnePointOfAPackEndsWhileItsJobRuns) {
  JobTrace trace = shown("RUNNING");
  EXPECT_EQ(life_of_job(trace, patience_s).life, Life::alive);
  trace.status = 137;
  const JobLife life = life_of_job(trace, patience_s);
  EXPECT_EQ(life.life, Life::dead);
  EXPECT_EQ(life.action, JobAction::none);  // the others go on
  EXPECT_THAT(life.words, HasSubstr("137"));
}

TEST(JobLife, EndOfAnEarlierStartIsNoEndOfAJobThatRunsAgain) {
  JobTrace trace = shown("RUNNING");
  trace.exit_code = 75;
  trace.has_started_anew = true;  // its script is about to claim the next attempt
  EXPECT_EQ(life_of_job(trace, patience_s).life, Life::alive);
  trace.has_started_anew = false;
  EXPECT_EQ(life_of_job(trace, patience_s).life, Life::dead);
}

TEST(JobLife, LauncherThatEndsWithZeroAndNoRecordProvesNoEnd) {
  JobTrace trace = shown("RUNNING");
  trace.status = 0;
  EXPECT_EQ(life_of_job(trace, patience_s).life, Life::alive);
  JobTrace forgotten = absent(patience_s);
  forgotten.status = 0;
  EXPECT_EQ(life_of_job(forgotten, patience_s).life, Life::alive);
  forgotten.exit_code = 75;
  EXPECT_EQ(life_of_job(forgotten, patience_s).life, Life::dead);
}

TEST(JobLife, EndOfTheJobIsTheEndWithItsCause) {
  EXPECT_EQ(life_of_job(shown("TIMEOUT", "TimeLimit"), patience_s).cause, Cause::time_limit);
  EXPECT_EQ(life_of_job(shown("NODE_FAIL", "NodeDown"), patience_s).cause, Cause::node);
  EXPECT_EQ(life_of_job(shown("PREEMPTED"), patience_s).cause, Cause::preempted);
  EXPECT_EQ(life_of_job(shown("OUT_OF_MEMORY"), patience_s).cause, Cause::memory);
  EXPECT_EQ(life_of_job(shown("TIMEOUT", "TimeLimit"), patience_s).life, Life::dead);
}

TEST(JobLife, ForgottenJobIsOverOnlyByItsFilesOrAfterLongSilence) {
  EXPECT_EQ(life_of_job(absent(patience_s), patience_s).life, Life::alive);
  const JobLife lost = life_of_job(absent(patience_s + 1), patience_s);
  EXPECT_EQ(lost.life, Life::dead);
  EXPECT_EQ(lost.cause, Cause::unclear);
  JobTrace ended = absent(0);
  ended.exit_code = 75;
  EXPECT_EQ(life_of_job(ended, patience_s).life, Life::dead);
}

TEST(JobLife, SubmissionWithoutARecordIsLookedForBeforeItIsGivenUp) {
  JobTrace trace = absent(0);
  trace.job.clear();
  trace.is_submitted = false;
  trace.is_released = false;
  trace.since_intent_s = submission_patience_s;
  EXPECT_EQ(life_of_job(trace, patience_s).life, Life::alive);
  trace.since_intent_s = submission_patience_s + 1;
  EXPECT_EQ(life_of_job(trace, patience_s).life, Life::none);
}

}  // namespace
}  // namespace rouleau::campaign
