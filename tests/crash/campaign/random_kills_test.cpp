// SPDX-License-Identifier: BSD-3-Clause
// kill -9 of ranks, of mpirun and of `rouleau run` at random moments, then plain `rouleau run`: the database must not
// show it. With SOAK set in the environment some hundred kills, and a line of figures for each test (share/soak.sh).
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "support/campaign_outcome.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignOutcome;
using rouleau::testing::CampaignProgram;
using rouleau::testing::eventually;
using rouleau::testing::outcome_of;

/// Always the same, unless CRASH_SEED asks for other moments.
unsigned seed() {
  const char* text = std::getenv("CRASH_SEED");
  return text == nullptr ? 20201U : static_cast<unsigned>(std::atoi(text));
}

bool is_soak() { return std::getenv("SOAK") != nullptr; }

void make(const CampaignProgram& program, int kills) {
  // 1000 steps a point for 40 kills, a checkpoint every 20: a job takes about half a second and meets several of them.
  CampaignProgram::set_speed(400, 20);
  program.write_study("fluid.lambda = 1, 4:5.5:0.5, 8\nreplicas = 2",
                      "[cell]\njitter_um = 0.1\n" + CampaignProgram::execution("retries = 1000\n"),
                      fmt::format("{}", 0.0025 * kills));
  ASSERT_EQ(program.init().status, 0);
}

/// What a kill hits. `everything`: manager and all ranks at once, as a machine that goes down.
enum class Victim { launcher, manager, rank, everything };

/// Kills of each kind that have hit something; `everything` counts as a manager's and a rank's.
struct Kills {
  int done = 0, launchers = 0, managers = 0, ranks = 0;
};

/// The first three kills come to one of each kind, the launcher's first, which few of the others hit; then by chance.
Victim next_victim(const Kills& kills, bool has_launchers, std::mt19937& random) {
  if (has_launchers && kills.launchers == 0) return Victim::launcher;
  if (kills.managers == 0 && kills.done > 0) return Victim::manager;
  if (kills.ranks == 0 && kills.done > 0) return Victim::rank;
  const int lot = std::uniform_int_distribution<>(0, 9)(random);
  if (lot < 5) return lot == 4 ? Victim::everything : Victim::manager;
  return lot == 9 && has_launchers ? Victim::launcher : Victim::rank;
}

/// Kills one process of that kind, if one lives, or everything.   returns whether there was anything to kill
bool kill_something(const CampaignProgram& program, Victim victim, pid_t& manager, std::mt19937& random, Kills& kills) {
  const bool takes_all = victim == Victim::everything;
  bool has_killed = false;
  if ((takes_all || victim == Victim::manager) && ::kill(manager, SIGKILL) == 0) {
    CampaignProgram::wait_for(manager);
    manager = 0;
    ++kills.managers;
    has_killed = true;
  }
  if (victim != Victim::manager) {
    std::vector<pid_t> jobs = victim == Victim::launcher ? program.launchers() : program.jobs();
    std::shuffle(jobs.begin(), jobs.end(), random);
    if (!takes_all && jobs.size() > 1) jobs.erase(jobs.begin() + 1, jobs.end());
    bool has_hit = false;
    for (const pid_t job : jobs) has_hit = ::kill(job, SIGKILL) == 0 || has_hit;
    if (has_hit) ++(victim == Victim::launcher ? kills.launchers : kills.ranks);
    has_killed = has_killed || has_hit;
  }
  if (has_killed) ++kills.done;
  return has_killed;
}

/// Three runs of a coarse cell, with a checkpoint at every look at the clock.
std::string real_study(int ranks, int kills) {
  return "[study]\nname = real\n[sweep]\nfluid.lambda = 1, 5, 8\n"
         "[channel]\nlength_x_um = 16\nlength_y_um = 12\nlength_z_um = 10\n"
         "[flow]\nmean_velocity_mm_per_s = 1.5\ninitial = developed\n"
         "[cell]\nsubdivisions = 3\noffset_y_um = 0.5\n[membrane]\nbending_modulus_J = 1e-18\n"
         "[numerics]\nnode_spacing_um = 2/3\ntime_step_us = 1.25\ncorrection_interval = 50\n"
         "[time]\nend_time_s = " +
         fmt::format("{}", 0.00125 * kills) +
         "\n"
         "[output]\nsample_interval_steps = 40\ncheckpoint_interval_min = 0.001\nprogress_interval_s = 0.5\n"
         "[analysis]\nwindow_s = 0.002\noscillation_window_s = 0.004\n" +
         CampaignProgram::execution(fmt::format("retries = 1000\nranks = {}\n", ranks));
}

/// A line for share/soak.sh: what the kills have cost.
void report(const CampaignOutcome& expected, const CampaignOutcome& found, int kills, int manual_steps) {
  std::size_t lost_samples = 0, wrong_resumes = 0;
  for (std::size_t i = 0; i < expected.points.size(); ++i) {
    const std::size_t all = expected.samples[i].size(), kept = found.samples[i].size();
    lost_samples += all > kept ? all - kept : 0;
    wrong_resumes += found.logs[i] != expected.logs[i] ? 1 : 0;
  }
  fmt::print("{{\"kills\": {}, \"lost_samples\": {}, \"wrong_resumes\": {}, \"manual_steps\": {}}}\n", kills,
             lost_samples, wrong_resumes, manual_steps);
}

/// Runs `disturbed` under random kills, then to its end; expects what `undisturbed` has. On several ranks mpirun is
/// among the victims.
void expect_no_trace(const CampaignProgram& undisturbed, const CampaignProgram& disturbed, int kills, int ranks = 1) {
  const auto begin = std::chrono::steady_clock::now();
  const auto calm = undisturbed.run();
  ASSERT_EQ(calm.status, 0) << calm.err << undisturbed.rouleau({"status", "c"}).out;
  const auto took = std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - begin);

  // What the undisturbed run took sets the pauses, half of it at the most: a fast machine, or one that was busy only
  // then, sees all the kills too.
  std::mt19937 random(seed());
  std::uniform_int_distribution<> pause_ms(0, static_cast<int>(took.count()) / (2 * kills));
  pid_t manager = disturbed.start({"run", "c"});
  Kills done;
  for (int tries = 0; done.done < kills && tries < 10 * kills; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms(random)));
    const Victim victim = next_victim(done, ranks > 1, random);
    // A launcher lives for a part of the time only: the aim is kept for a while, so that it is one that is hit.
    for (int looks = 0; !kill_something(disturbed, victim, manager, random, done); ++looks) {
      if (victim != Victim::launcher || looks == 1000) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    int status = 0;
    if (manager != 0 && ::waitpid(manager, &status, WNOHANG) == manager) break;  // all done before the last kill
    if (manager == 0) manager = disturbed.start({"run", "c"});
  }
  if (manager != 0) {
    ::kill(manager, SIGKILL);
    CampaignProgram::wait_for(manager);
  }
  ::testing::Test::RecordProperty("kills", done.done);
  EXPECT_EQ(done.done, kills) << "the campaign was over too soon";
  fmt::print("{} kills of managers, {} of ranks, {} of mpirun\n", done.managers, done.ranks, done.launchers);
  if (ranks > 1) {
    EXPECT_GT(done.launchers, 0);
  }
  if (kills > 2) {
    EXPECT_GT(done.managers, 0);
    EXPECT_GT(done.ranks, 0);
  }

  const auto capture = disturbed.run();
  EXPECT_EQ(capture.status, 0) << capture.err;
  EXPECT_TRUE(eventually([&] { return disturbed.jobs().empty() && disturbed.launchers().empty(); }))
      << "a process is left over";
  const CampaignOutcome expected = outcome_of(undisturbed);
  const CampaignOutcome found = outcome_of(disturbed);
  ASSERT_EQ(found.points.size(), expected.points.size());
  // Nothing but `rouleau run` is called: where it does not do, somebody would have to take a step.
  if (is_soak()) report(expected, found, done.done, capture.status != 0 ? 1 : 0);
  for (std::size_t i = 0; i < expected.points.size(); ++i) {
    EXPECT_EQ(found.points[i], expected.points[i]) << i;
    EXPECT_EQ(found.parameters[i], expected.parameters[i]) << i;
    EXPECT_EQ(found.samples[i], expected.samples[i]) << i;
    EXPECT_EQ(found.results[i], expected.results[i]) << i;
    EXPECT_EQ(found.logs[i], expected.logs[i]) << i;
  }
  std::size_t attempts = 0;
  for (const PointRow& point : found.points) attempts += disturbed.store().attempts(point.key).size();
  EXPECT_GT(attempts, found.points.size()) << "no kill has hit a job: the test proves nothing";
  ::testing::Test::RecordProperty("attempts", static_cast<int>(attempts));
  const auto check = disturbed.rouleau({"verify", "c"});
  EXPECT_EQ(check.status, 0) << "the campaign's own check disagrees:\n" << check.out << check.err;
}

TEST(CampaignCrash, RandomKillsLeaveNoTraceInTheDatabase) {
  const int kills = is_soak() ? 160 : 40;
  const CampaignProgram undisturbed, disturbed;
  make(undisturbed, kills);
  make(disturbed, kills);
  expect_no_trace(undisturbed, disturbed, kills);
}

struct RealRuns {
  int ranks, kills, kills_in_soak;
};

class RandomKills : public ::testing::TestWithParam<RealRuns> {};

TEST_P(RandomKills, OfRealSolversLeaveNoTraceInTheDatabase) {
  const int kills = is_soak() ? GetParam().kills_in_soak : GetParam().kills;
  const CampaignProgram undisturbed(REAL_SOLVER_PROGRAM), disturbed(REAL_SOLVER_PROGRAM);
  for (const CampaignProgram* program : {&undisturbed, &disturbed}) {
    rouleau::testing::set_content(program->study(), real_study(GetParam().ranks, kills));
    const auto made = program->init();
    ASSERT_EQ(made.status, 0) << made.err;
  }
  expect_no_trace(undisturbed, disturbed, kills, GetParam().ranks);
}

INSTANTIATE_TEST_SUITE_P(Ranks, RandomKills,
                         ::testing::Values(RealRuns{1, 8, 60}, RealRuns{2, 2, 50}, RealRuns{3, 2, 50}),
                         [](const auto& test) { return fmt::format("On{}", test.param.ranks); });

}  // namespace
}  // namespace rouleau::campaign
