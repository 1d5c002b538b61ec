// SPDX-License-Identifier: BSD-3-Clause
// Job scripts as bash runs them: first and further starts, races, signals, deadlines.
#include "job_script_run.hpp"

#include <gmock/gmock.h>

#include <regex>
#include <set>

namespace rouleau::campaign {
namespace {

using rouleau::testing::content_of;
using rouleau::testing::eventually;
using rouleau::testing::set_content;
using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(JobScriptRun, FirstStartRunsTheClaimedAttempt) {
  add_point("a", "exit 0");
  EXPECT_EQ(run(), 0);
  EXPECT_TRUE(std::filesystem::is_directory(attempt("a", 1) / "begun"));
  EXPECT_EQ(content_of(attempt("a", 1) / "status"), "0\n");
  EXPECT_EQ(content_of(attempt("a", 1) / "arguments"),
            "run.ini\n--attempt\n1\n--token\n" + given_token + "\n--deadline-s\n3600\n");
  EXPECT_EQ(content_of(attempt("a", 1) / "stdout"), "srun --mpi=pmix --exact -n 1\n");
  EXPECT_FALSE(std::filesystem::exists(attempt("a", 2)));
  EXPECT_FALSE(std::filesystem::exists(campaign_ / "hacked"));
  EXPECT_FALSE(std::filesystem::exists("hacked"));
}

TEST_F(JobScriptRun, SecondStartClaimsAnAttemptOfItsOwn) {
  add_point("a", "exit 75");
  EXPECT_EQ(run(), 0);
  ::setenv("SLURM_JOB_ID", "4712", 1);
  EXPECT_EQ(run(), 0);
  const std::string owner = content_of(attempt("a", 2) / "owner");
  EXPECT_TRUE(std::regex_match(owner, std::regex("[0-9a-f]{32}\n"))) << owner;
  EXPECT_NE(owner, given_token + "\n");
  EXPECT_EQ(content_of(attempt("a", 2) / "job"), "slurm 4712 rouleau-" + given_token + "\n");
  EXPECT_TRUE(std::filesystem::is_directory(attempt("a", 2) / "begun"));
  EXPECT_EQ(content_of(attempt("a", 2) / "status"), "75\n");
  EXPECT_THAT(content_of(attempt("a", 2) / "arguments"), HasSubstr("--attempt\n2\n--token\n" + owner));
  EXPECT_EQ(run(), 0);
  EXPECT_TRUE(std::filesystem::exists(attempt("a", 3) / "status"));
  EXPECT_THAT(log(), HasSubstr("point a: attempt 1 has begun before; this start is attempt 2"));
}

TEST_F(JobScriptRun, NumbersOfAttemptsAreComparedAsNumbers) {
  add_point("a", "exit 75");
  std::filesystem::create_directory(attempt("a", 1) / "begun");
  for (int k : {2, 9, 10}) {
    std::filesystem::create_directories(attempt("a", k));
    set_content(attempt("a", k) / "job", "slurm 1 rouleau-" + given_token + "\n");
  }
  std::filesystem::create_directories(campaign_ / "points/a/attempts/99x");
  std::filesystem::create_directories(campaign_ / "points/a/attempts/011");
  EXPECT_EQ(run(), 0);
  EXPECT_TRUE(std::filesystem::exists(attempt("a", 11) / "status"));
}

TEST_F(JobScriptRun, PointThatSomebodyElseHasTakenOverIsLeftAlone) {
  add_point("a", "exit 75");
  add_point("b", "exit 75");
  std::filesystem::create_directory(attempt("a", 1) / "begun");
  claim_attempt(campaign_ / "points/a", 2, "another");  // by a local engine: it has no job file
  std::filesystem::create_directory(attempt("b", 1) / "begun");
  claim_attempt(campaign_ / "points/b", 2, "another");
  set_content(attempt("b", 2) / "job", "slurm 5000 rouleau-another\n");
  EXPECT_EQ(run(), 0);
  EXPECT_FALSE(std::filesystem::exists(attempt("a", 3)));
  EXPECT_FALSE(std::filesystem::exists(attempt("b", 3)));
  EXPECT_THAT(log(), HasSubstr("point a: attempt 2 has taken it over; it is left alone"));
  EXPECT_THAT(log(), HasSubstr("point b: attempt 2 has taken it over; it is left alone"));
}

TEST_F(JobScriptRun, TwoStartsAtOnceNeverShareAnAttempt) {
  for (int k = 0; k < 5; ++k) add_point("p" + std::to_string(k), "exit 75");
  std::vector<pid_t> copies;
  for (int i = 0; i < 4; ++i) copies.push_back(start());
  for (const pid_t copy : copies) EXPECT_EQ(end_of(copy), 0);
  for (const ScriptPoint& point : job_.points) {
    int begun = 0;
    std::set<std::string> owners;
    for (int k = 1; std::filesystem::exists(attempt(point.key, k)); ++k) {
      EXPECT_TRUE(std::filesystem::exists(attempt(point.key, k) / "status")) << point.key << ' ' << k;
      owners.insert(content_of(attempt(point.key, k) / "owner"));
      // One start each: a second one would have appended its line.
      EXPECT_EQ(content_of(attempt(point.key, k) / "stdout"), "srun --mpi=pmix --exact -n 1 --mem=0\n");
      ++begun;
    }
    EXPECT_GE(begun, 1);
    EXPECT_EQ(owners.size(), static_cast<std::size_t>(begun));
  }
}

TEST_F(JobScriptRun, RequeuedJobLeavesPointsThatHaveEndedAlone) {
  const std::vector<std::pair<int, bool>> goes_on_after = {{0, false}, {65, false}, {70, false}, {76, false},
                                                           {75, true}, {74, true},  {137, true}};
  for (const auto& [code, goes_on] : goes_on_after) {
    const std::string key = "p" + std::to_string(code);
    add_point(key, "exit 75");
    std::filesystem::create_directory(attempt(key, 1) / "begun");
    set_content(attempt(key, 1) / "exit.json",
                fmt::format("{{\n \"contract\": 1,\n \"code\": {},\n \"x\": 0}}\n", code));
  }
  add_point("silent", "exit 75");  // without an exit record: its node died
  std::filesystem::create_directory(attempt("silent", 1) / "begun");
  ::setenv("SLURM_RESTART_COUNT", "1", 1);
  EXPECT_EQ(run(), 0);
  for (const auto& [code, goes_on] : goes_on_after) {
    EXPECT_EQ(std::filesystem::exists(attempt("p" + std::to_string(code), 2)), goes_on) << code;
  }
  EXPECT_TRUE(std::filesystem::exists(attempt("silent", 2)));
  // By hand everything is started again: whoever does that means it.
  ::unsetenv("SLURM_RESTART_COUNT");
  EXPECT_EQ(run(), 0);
  EXPECT_TRUE(std::filesystem::exists(attempt("p70", 2)));
}

TEST_F(JobScriptRun, SignalIsPassedOnAndTheStatusIsWrittenWhenTheSolverHasEnded) {
  add_point("a", "wait");
  add_point("b", "wait");
  const pid_t script = start();
  ASSERT_TRUE(eventually([&] {
    return std::filesystem::exists(attempt("a", 1) / "started.json") &&
           std::filesystem::exists(attempt("b", 1) / "started.json");
  }));
  EXPECT_FALSE(std::filesystem::exists(attempt("a", 1) / "status"));
  ::kill(script, SIGUSR2);
  EXPECT_EQ(end_of(script), 0);
  for (const char* key : {"a", "b"}) {
    EXPECT_EQ(content_of(attempt(key, 1) / "stopped"), "stopped\n");
    EXPECT_EQ(content_of(attempt(key, 1) / "status"), "75\n");
  }
}

TEST_F(JobScriptRun, SignalWaitsForASolverThatCannotTakeItYet) {
  add_point("a", "wait 1");
  const pid_t script = start();
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(attempt("a", 1) / "arguments"); }));
  ASSERT_FALSE(std::filesystem::exists(attempt("a", 1) / "started.json"));
  ::kill(script, SIGUSR2);
  EXPECT_EQ(end_of(script), 0);
  EXPECT_EQ(content_of(attempt("a", 1) / "status"), "75\n");  // 140 if it had been killed
}

// `wait` returns 140 for the signal, and by the next line the solver may have ended with another status.
TEST_F(JobScriptRun, StatusIsTheSolversEvenIfItEndsWhileItIsBeingTold) {
  cluster_.setup = {"kill() { local status=0; builtin kill \"$@\" || status=1; sleep 0.3; return $status; }"};
  add_point("a", "wait");
  const pid_t script = start();
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(attempt("a", 1) / "started.json"); }));
  ::kill(script, SIGUSR2);
  EXPECT_EQ(end_of(script), 0);
  EXPECT_EQ(content_of(attempt("a", 1) / "status"), "75\n");
}

TEST_F(JobScriptRun, SecondSignalDoesNoHarm) {
  add_point("a", "wait 0.3");
  const pid_t script = start();
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(attempt("a", 1) / "arguments"); }));
  for (int i = 0; i < 20; ++i) {
    ::kill(script, SIGUSR2);
    ::usleep(20000);
  }
  EXPECT_EQ(end_of(script), 0);
  EXPECT_EQ(content_of(attempt("a", 1) / "status"), "75\n");
}

TEST_F(JobScriptRun, TerminationIsAStopWithoutTheCommandAtTheEnd) {
  add_point("a", "wait");
  job_.at_end = {"touch", "at end"};
  const pid_t script = start();
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(attempt("a", 1) / "started.json"); }));
  ::kill(script, SIGTERM);
  EXPECT_EQ(end_of(script), 0);
  EXPECT_EQ(content_of(attempt("a", 1) / "status"), "75\n");
  EXPECT_FALSE(std::filesystem::exists(campaign_ / "at end"));
}

TEST_F(JobScriptRun, CommandAtTheEndRunsWhenAllPointsHaveEnded) {
  add_point("a", "exit 0");
  add_point("b", "exit 75");
  job_.at_end = {"sh", "-c", "cat points/*/attempts/1/status >'at end'"};
  EXPECT_EQ(run(), 0);
  EXPECT_EQ(content_of(campaign_ / "at end"), "0\n75\n");
  // Its minute is taken from the solver's time.
  EXPECT_THAT(content_of(attempt("a", 1) / "arguments"), HasSubstr("--deadline-s\n3540\n"));
}

TEST_F(JobScriptRun, BadEndOfOnePointIsTheJobsAndDoesNotStopTheOthers) {
  add_point("a", "exit 70");
  add_point("b", "exit 0");
  EXPECT_EQ(run(), 70);
  EXPECT_EQ(content_of(attempt("a", 1) / "status"), "70\n");
  EXPECT_EQ(content_of(attempt("b", 1) / "status"), "0\n");
}

TEST_F(JobScriptRun, MissingAttemptIsLeftAloneAndTheOthersRun) {
  add_point("a", "exit 0");
  add_point("b", "exit 0");
  add_point("c", "exit 0");
  std::filesystem::remove_all(attempt("b", 1));
  std::filesystem::remove_all(campaign_ / "points/c");
  EXPECT_EQ(run(), 0);
  EXPECT_EQ(content_of(attempt("a", 1) / "status"), "0\n");
  EXPECT_FALSE(std::filesystem::exists(attempt("b", 1)));
  EXPECT_THAT(log(), HasSubstr("point b: there is no attempt 1"));
}

TEST_F(JobScriptRun, DeadlineIsReadFromAllThatSlurmSays) {
  struct Left {
    const char* words;
    const char* deadline;  ///< "" = none is given
  };
  // 7200 is the time limit of the cluster file, which holds when Slurm says nothing of use.
  const std::vector<Left> table = {
      {"echo 59:08", "3548"},
      {"echo 0:45", "45"},
      {"echo 1:02:03", "3723"},
      {"echo 08:09:09", "29349"},
      {"echo 2-03:04:05", "183845"},
      {"echo 10-00:00:00", "864000"},
      {"echo 0:00", "1"},
      {"echo UNLIMITED", ""},
      {"echo INVALID", "7200"},
      {"echo NOT_SET", "7200"},
      {"echo", "7200"},
      {"exit 1", "7200"},
      {"echo 'motd: 3 news'; echo '  5:00  '", "300"},
      {"echo 5", "7200"},
      {"echo '$(id)'", "7200"},
      {"echo 'a[$(touch hacked)]:00'", "7200"},
  };
  for (std::size_t i = 0; i < table.size(); ++i) {
    SCOPED_TRACE(table[i].words);
    const std::string key = "p" + std::to_string(i);
    job_.points.clear();
    add_point(key, "exit 0");
    install("squeue", std::string("#!/bin/bash\n") + table[i].words + "\n");
    EXPECT_EQ(run(), 0);
    const std::string arguments = content_of(attempt(key, 1) / "arguments");
    if (*table[i].deadline == '\0') {
      EXPECT_THAT(arguments, Not(HasSubstr("--deadline-s")));
    } else {
      // A second may have passed on a busy machine.
      const std::size_t at = arguments.find("--deadline-s\n");
      ASSERT_NE(at, std::string::npos);
      const int given = std::stoi(arguments.substr(at + 13));
      EXPECT_LE(given, std::stoi(table[i].deadline));
      EXPECT_GE(given, std::stoi(table[i].deadline) - 5);
    }
  }
  EXPECT_FALSE(std::filesystem::exists(campaign_ / "hacked"));
}

TEST_F(JobScriptRun, OutsideOfAJobItRefuses) {
  add_point("a", "exit 0");
  ::unsetenv("SLURM_JOB_ID");
  EXPECT_EQ(run(), 1);
  EXPECT_THAT(log(), HasSubstr("submit the script with sbatch"));
  EXPECT_FALSE(std::filesystem::exists(attempt("a", 1) / "begun"));
}

TEST_F(JobScriptRun, SetupPreparesTheSolversWorldAndCannotUpsetTheScript) {
  add_point("a", "exit 0");
  cluster_.setup = {"export GREETING='hello'", "set -eu",      "cd /", "solver=/nowhere name=x",
                    "trap 'echo bye' USR2",    "false || true"};
  install("the solver", "#!/bin/bash\necho \"$GREETING from $(basename \"$PWD\")\"\nexit 3\n");
  EXPECT_EQ(run(), 3);
  EXPECT_THAT(content_of(attempt("a", 1) / "stdout"), HasSubstr("hello from a\n"));
  EXPECT_EQ(content_of(attempt("a", 1) / "status"), "3\n");
}

}  // namespace
}  // namespace rouleau::campaign
