// SPDX-License-Identifier: BSD-3-Clause
// The judge: every exit code of the contract, with and without progress, alive, dead and out of sight.
#include "jobs/judge.hpp"

#include <gmock/gmock.h>

namespace rouleau::campaign {
namespace {

using testing::HasSubstr;

const RetryPolicy policy{3, 10, 60};

Recorded running(int retries_used = 0) {
  Recorded recorded;
  recorded.state = State::running;
  recorded.attempt = 2;
  recorded.attempt_is_open = true;
  recorded.checkpoint_at_start = 100;
  recorded.retries_used = retries_used;
  recorded.end_step = 1000;
  return recorded;
}

Evidence dead(std::int64_t newest_checkpoint = 100) {
  Evidence evidence;
  evidence.newest_attempt = 2;
  evidence.life = Life::dead;
  evidence.newest_checkpoint = newest_checkpoint;
  return evidence;
}

Evidence ended(int code, std::int64_t step, std::int64_t newest_checkpoint = 100) {
  Evidence evidence = dead(newest_checkpoint);
  evidence.exit = ExitRecord{code, "why", 100, step};
  return evidence;
}

TEST(CampaignJudge, FollowsTheExitCodesOfTheContract) {
  EXPECT_EQ(judge(running(), ended(0, 1000), policy).state, State::done);
  EXPECT_EQ(judge(running(), ended(75, 500), policy).state, State::stopped);
  EXPECT_EQ(judge(running(), ended(65, 100), policy).state, State::refused);
  EXPECT_EQ(judge(running(), ended(70, 500), policy).state, State::failed);
  EXPECT_EQ(judge(running(), ended(74, 500), policy).state, State::crashed);
  EXPECT_EQ(judge(running(), ended(76, 500), policy).state, State::crashed);
  EXPECT_EQ(judge(running(), ended(64, 100), policy).state, State::crashed);
  EXPECT_EQ(judge(running(), ended(139, 100), policy).state, State::crashed);
  EXPECT_EQ(judge(running(), dead(), policy).state, State::crashed);
}

TEST(CampaignJudge, EveryVerdictClosesTheAttemptAndSaysWhy) {
  for (const int code : {0, 64, 65, 70, 74, 75, 76, 1, 139}) {
    const Verdict verdict = judge(running(), ended(code, 1000), policy);
    EXPECT_TRUE(verdict.attempt_ended) << code;
    EXPECT_THAT(verdict.evidence, HasSubstr("attempt 2")) << code;
    EXPECT_THAT(verdict.evidence, HasSubstr("why")) << code;
  }
}

TEST(CampaignJudge, LivingProcessIsLeftAlone) {
  Evidence alive = dead(500);
  alive.life = Life::alive;
  EXPECT_EQ(judge(running(), alive, policy).state, State::running);
  EXPECT_FALSE(judge(running(), alive, policy).attempt_ended);
  // A process that has written its record but not ended yet will end by itself.
  alive.exit = ExitRecord{0, "end", 0, 1000};
  EXPECT_FALSE(judge(running(), alive, policy).attempt_ended);
}

TEST(CampaignJudge, SilenceChangesNothing) {
  Evidence unknown = dead(500);
  unknown.life = Life::unknown;
  const Verdict verdict = judge(running(), unknown, policy);
  EXPECT_EQ(verdict.state, State::running);
  EXPECT_FALSE(verdict.attempt_ended);
  EXPECT_EQ(verdict.evidence, "");
}

TEST(CampaignJudge, RecordIsBelievedEvenIfTheProcessIsOutOfSight) {
  Evidence unknown = ended(0, 1000);
  unknown.life = Life::unknown;
  EXPECT_EQ(judge(running(), unknown, policy).state, State::done);
}

TEST(CampaignJudge, CrashAfterProgressIsRetriedAtOnceAndNotCounted) {
  const Verdict verdict = judge(running(2), dead(150), policy);
  EXPECT_EQ(verdict.state, State::crashed);
  EXPECT_EQ(verdict.retries_used, 0) << "retries are counted in a row";
  EXPECT_EQ(verdict.retry_in_s, 0);
}

TEST(CampaignJudge, CrashesWithoutProgressAreCountedAndBackOff) {
  EXPECT_EQ(judge(running(0), dead(), policy).retry_in_s, 10);
  EXPECT_EQ(judge(running(1), dead(), policy).retry_in_s, 20);
  EXPECT_EQ(judge(running(2), dead(), policy).retry_in_s, 40);
  EXPECT_EQ(judge(running(2), dead(), policy).retries_used, 3);
  EXPECT_EQ(judge(running(3), dead(), policy).state, State::exhausted);
}

TEST(CampaignJudge, FirstCheckpointOfAllIsProgress) {
  Recorded first = running();
  first.checkpoint_at_start = -1;
  EXPECT_EQ(judge(first, dead(0), policy).retries_used, 0);
  EXPECT_EQ(judge(first, dead(-1), policy).retries_used, 1);
}

TEST(CampaignJudge, NoRetriesMeansNone) {
  EXPECT_EQ(judge(running(0), dead(), {0, 10, 60}).state, State::exhausted);
  EXPECT_EQ(judge(running(0), dead(200), {0, 10, 60}).state, State::crashed) << "progress needs no retry";
}

/// The n-th start from the same checkpoint, after so many counted crashes.
Recorded in_vain(int starts, int retries_used = 0) {
  Recorded recorded = running(retries_used);
  recorded.starts_in_vain = starts;
  return recorded;
}

TEST(CampaignJudge, FileErrorsWaitLonger) {
  EXPECT_EQ(judge(in_vain(1), ended(74, 100), policy).retry_in_s, 60);
  EXPECT_EQ(judge(in_vain(2), ended(74, 100), policy).retry_in_s, 240);
  EXPECT_EQ(judge(in_vain(2), ended(74, 100, 200), policy).retry_in_s, 60)
      << "a full disk after progress is still full";
}

TEST(CampaignJudge, FileErrorsUseUpNoRetriesHoweverManyThereAre) {
  for (const int starts : {1, 4, 100, 100000}) {
    const Verdict verdict = judge(in_vain(starts, policy.retries), ended(74, 100), policy);
    EXPECT_EQ(verdict.state, State::crashed) << starts;
    EXPECT_EQ(verdict.retries_used, policy.retries) << "crashes are counted apart";
    EXPECT_LE(verdict.retry_in_s, 3600) << starts;
    EXPECT_THAT(verdict.evidence, HasSubstr("not counted as a retry"));
  }
  EXPECT_EQ(judge(in_vain(100000), ended(74, 100), {3, 0, 0}).retry_in_s, 0);
}

TEST(CampaignJudge, BackOffHasAnEnd) {
  EXPECT_EQ(judge(running(500), dead(), {1000, 10, 60}).retry_in_s, 3600);
  EXPECT_EQ(judge(in_vain(100000), ended(74, 100), policy).retry_in_s, 3600);
}

TEST(CampaignJudge, StoppingWithoutAStepIsNoBusyLoop) {
  EXPECT_EQ(judge(running(), ended(75, 500), policy).retry_in_s, 0);
  EXPECT_EQ(judge(in_vain(1), ended(75, 100), policy).retry_in_s, 10);
  EXPECT_EQ(judge(in_vain(4), ended(75, 100), policy).retry_in_s, 80);
}

TEST(CampaignJudge, FinishedRunWithoutAllItsSamplesIsNotDone) {
  Evidence evidence = ended(0, 1000, 1000);
  evidence.sample_trouble = "samples.csv: line 7 is damaged";
  const Verdict verdict = judge(running(), evidence, policy);
  EXPECT_EQ(verdict.state, State::crashed) << "a continuation takes an older checkpoint";
  EXPECT_EQ(verdict.retries_used, 1);
  EXPECT_THAT(verdict.evidence, HasSubstr("but samples.csv: line 7 is damaged"));
  EXPECT_EQ(judge(running(policy.retries), evidence, policy).state, State::exhausted) << "but not for ever";
  EXPECT_FALSE(is_early_failure(running(), evidence, verdict));
  evidence.newest_checkpoint = -1;
  EXPECT_EQ(judge(running(), evidence, policy).state, State::refused) << "it would compute everything anew";
  EXPECT_THAT(judge(running(), evidence, policy).evidence, HasSubstr("rouleau retry"));
}

TEST(CampaignJudge, FinishedForAnEarlierEndGoesOn) {
  Recorded longer = running();
  longer.end_step = 2000;
  EXPECT_EQ(judge(longer, ended(0, 1000), policy).state, State::stopped);
  EXPECT_EQ(judge(longer, ended(0, 100), policy).state, State::refused)
      << "a solver that makes no step must not be started for ever";
}

TEST(CampaignJudge, LastWordsAreQuoted) {
  Evidence evidence = dead();
  evidence.last_words = "Segmentation fault";
  EXPECT_THAT(judge(running(), evidence, policy).evidence, HasSubstr("Segmentation fault"));
}

TEST(CampaignJudge, FinalStatesStayWithoutNews) {
  for (const State state : {State::done, State::failed, State::refused, State::exhausted, State::cancelled}) {
    Recorded recorded = running();
    recorded.state = state;
    recorded.attempt_is_open = false;
    const Verdict verdict = judge(recorded, ended(0, 1000), policy);
    EXPECT_EQ(verdict.state, state);
    EXPECT_EQ(verdict.evidence, "");
  }
}

TEST(CampaignJudge, CancelledPointStaysCancelledHoweverItsJobEnds) {
  Recorded cancelled = running(1);
  cancelled.state = State::cancelled;
  for (const Evidence& evidence : {ended(75, 500), ended(0, 1000), ended(70, 500), dead()}) {
    const Verdict verdict = judge(cancelled, evidence, policy);
    EXPECT_EQ(verdict.state, State::cancelled);
    EXPECT_TRUE(verdict.attempt_ended);
    EXPECT_EQ(verdict.retries_used, 1);
  }
}

TEST(CampaignJudge, PlannedButNeverStartedIsTakenBackUncounted) {
  Evidence nothing;
  nothing.newest_attempt = 2;
  nothing.newest_checkpoint = 100;
  const Verdict verdict = judge(running(2), nothing, policy);
  EXPECT_EQ(verdict.state, State::stopped);
  EXPECT_EQ(verdict.retries_used, 2);
  EXPECT_TRUE(verdict.attempt_ended);
  nothing.newest_checkpoint = -1;
  EXPECT_EQ(judge(running(), nothing, policy).state, State::waiting);
}

TEST(CampaignJudge, AttemptStartedByHandIsAdopted) {
  Recorded waiting;
  waiting.state = State::waiting;
  waiting.end_step = 1000;
  Evidence evidence = ended(0, 1000);
  evidence.newest_attempt = 1;
  EXPECT_EQ(judge(waiting, evidence, policy).state, State::done);
  evidence.exit.reset();
  evidence.life = Life::alive;
  const Verdict verdict = judge(waiting, evidence, policy);
  EXPECT_EQ(verdict.state, State::running);
  EXPECT_FALSE(verdict.attempt_ended);
  EXPECT_NE(verdict.evidence, "");
}

TEST(CampaignJudge, FailedLaunchIsDelayedLikeAFileErrorAndNeverGivenUp) {
  for (const LaunchTrouble trouble : {LaunchTrouble::files, LaunchTrouble::engine}) {
    const Verdict verdict = judge_failed_launch(in_vain(2, policy.retries), trouble, "no such file", policy);
    EXPECT_EQ(verdict.state, State::crashed);
    EXPECT_EQ(verdict.retries_used, policy.retries);
    EXPECT_EQ(verdict.retry_in_s, 240);
    EXPECT_THAT(verdict.evidence, HasSubstr("no such file"));
  }
}

TEST(CampaignJudge, DamageThatNoWaitingMendsUsesUpTheRetries) {
  EXPECT_EQ(judge_failed_launch(running(1), LaunchTrouble::damage, "x", policy).retries_used, 2);
  EXPECT_EQ(judge_failed_launch(running(3), LaunchTrouble::damage, "x", policy).state, State::exhausted);
}

TEST(CampaignJudge, EarlyFailureIsOneWithoutProgress) {
  const auto is_early = [](const Evidence& evidence) {
    return is_early_failure(running(), evidence, judge(running(), evidence, policy));
  };
  EXPECT_TRUE(is_early(dead()));
  EXPECT_TRUE(is_early(ended(70, 120)));
  EXPECT_TRUE(is_early(ended(65, 100)));
  EXPECT_FALSE(is_early(dead(150)));
  EXPECT_FALSE(is_early(ended(70, 500, 450)));
  EXPECT_FALSE(is_early(ended(0, 1000)));
  EXPECT_FALSE(is_early(ended(75, 100)));
  EXPECT_FALSE(is_early(ended(74, 100))) << "a full disk is waited out";
}

Evidence ended_by_slurm(Cause cause, std::int64_t newest_checkpoint = 100) {
  Evidence evidence = dead(newest_checkpoint);
  evidence.cause = cause;
  evidence.engine_words = "Slurm: words";
  return evidence;
}

TEST(CampaignJudge, WhatTheSchedulerDidIsNoRetryOfTheRun) {
  for (const Cause cause : {Cause::preempted, Cause::node, Cause::launch, Cause::unclear}) {
    const Verdict verdict = judge(running(policy.retries), ended_by_slurm(cause), policy);
    EXPECT_EQ(verdict.state, State::crashed);
    EXPECT_EQ(verdict.retries_used, policy.retries);
    EXPECT_GT(verdict.retry_in_s, 0);
    EXPECT_THAT(verdict.evidence, HasSubstr("Slurm: words"));
  }
}

TEST(CampaignJudge, WhatTheSchedulerDoesAgainAndAgainIsAnsweredEverMoreSlowly) {
  for (const Cause cause : {Cause::preempted, Cause::node, Cause::launch, Cause::unclear}) {
    EXPECT_EQ(judge(in_vain(1), ended_by_slurm(cause), policy).retry_in_s, 10);
    EXPECT_EQ(judge(in_vain(4), ended_by_slurm(cause), policy).retry_in_s, 80);
    EXPECT_EQ(judge(in_vain(400), ended_by_slurm(cause), policy).retry_in_s, 3600);
  }
}

TEST(CampaignJudge, TimeLimitAndMemoryWithoutProgressAreCounted) {
  for (const Cause cause : {Cause::time_limit, Cause::memory, Cause::cancelled, Cause::none}) {
    EXPECT_EQ(judge(running(0), ended_by_slurm(cause), policy).retries_used, 1);
    EXPECT_EQ(judge(running(policy.retries), ended_by_slurm(cause), policy).state, State::exhausted);
    EXPECT_EQ(judge(running(policy.retries), ended_by_slurm(cause, 200), policy).retries_used, 0);
  }
}

TEST(CampaignJudge, CancelledJobIsNotBroughtBackAtOnce) {
  EXPECT_GE(judge(running(), ended_by_slurm(Cause::cancelled), policy).retry_in_s, policy.io_retry_delay_s);
}

TEST(CampaignJudge, RequestThatCanNeverStartIsRefused) {
  Evidence evidence = ended_by_slurm(Cause::none);
  evidence.can_never_start = true;
  const Verdict verdict = judge(running(), evidence, policy);
  EXPECT_EQ(verdict.state, State::refused);
  EXPECT_THAT(verdict.evidence, HasSubstr("rouleau retry"));
}

TEST(CampaignJudge, PreemptionAndLostNodesDoNotCountTowardsThePause) {
  for (const Cause cause : {Cause::preempted, Cause::node}) {
    const Evidence evidence = ended_by_slurm(cause);
    EXPECT_FALSE(is_early_failure(running(), evidence, judge(running(), evidence, policy)));
  }
  const Evidence launch = ended_by_slurm(Cause::launch);
  EXPECT_TRUE(is_early_failure(running(), launch, judge(running(), launch, policy)));
}

}  // namespace
}  // namespace rouleau::campaign
