// SPDX-License-Identifier: BSD-3-Clause
// The text of job scripts: options, launchers, quotes.
#include "executor/job_script.hpp"

#include <gmock/gmock.h>

#include "executor/capture.hpp"
#include "study/error.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::campaign {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

JobScript one_point() {
  return {.solver = "/opt/bin/rouleau-solver",
          .campaign = "/data/sweep",
          .name = "rouleau-ab12",
          .ranks = 4,
          .points = {{"0123abcd", 3, "ab12"}},
          .at_end = {}};
}

JobScript pack() {
  JobScript job = one_point();
  job.ranks = 1;
  job.points = {{"a", 1, "t1"}, {"b", 2, "t2"}, {"c", 3, "t3"}};
  return job;
}

Cluster day() {
  Cluster cluster;
  cluster.time_limit_s = 86400 + 3600 + 61;
  return cluster;
}

TEST(JobScriptText, AsksForOnePoint) {
  const std::string text = job_script(day(), one_point());
  EXPECT_TRUE(text.starts_with("#!/bin/bash\n#SBATCH --job-name=rouleau-ab12\n"));
  for (const char* line :
       {"#SBATCH --output=/data/sweep/points/0123abcd/attempts/3/job.log\n", "#SBATCH --open-mode=append\n",
        "#SBATCH --time=1-01:01:01\n", "#SBATCH --nodes=1\n", "#SBATCH --ntasks=4\n", "#SBATCH --signal=B:USR2@120\n",
        "#SBATCH --requeue\n", "\nlauncher=(srun --mpi=pmix --exact -n 4 --wait=60)\n", "\nat_end=()\n",
        "\nlimit_s=90061\n", "\nmargin_s=0\n", "\nkeys=(0123abcd)\nattempts=(3)\ntokens=(ab12)\n"}) {
    EXPECT_THAT(text, HasSubstr(line));
  }
  for (const char* absent : {"--partition", "--account", "--qos", "--mem", "--no-requeue"}) {
    EXPECT_THAT(text, Not(HasSubstr(absent)));
  }
}

TEST(JobScriptText, AsksForAllThatTheClusterFileSays) {
  Cluster cluster = day();
  cluster.partition = "batch";
  cluster.account = "p1";
  cluster.qos = "high";
  cluster.nodes = 2;
  cluster.memory_per_rank_MiB = 500;
  cluster.signal_s = 0;
  cluster.requeue = 0;
  cluster.sbatch = {"--exclusive", "-C fast"};
  cluster.setup = {"module load a", "export B='c d'"};
  const std::string text = job_script(cluster, one_point());
  for (const char* line : {"#SBATCH --partition=batch\n", "#SBATCH --account=p1\n", "#SBATCH --qos=high\n",
                           "#SBATCH --nodes=2\n", "#SBATCH --mem-per-cpu=500M\n", "#SBATCH --no-requeue\n",
                           "#SBATCH --exclusive\n#SBATCH -C fast\n", "\nmodule load a\nexport B='c d'\n"}) {
    EXPECT_THAT(text, HasSubstr(line));
  }
  EXPECT_THAT(text, Not(HasSubstr("--signal")));
  // sbatch reads options up to the first command.
  EXPECT_LT(text.rfind("#SBATCH"), text.find("cd /data/sweep"));
  // The setup cannot change what we set afterwards.
  EXPECT_LT(text.find("module load a"), text.find("campaign=/data"));
}

TEST(JobScriptText, PackSharesTheJobAmongItsPoints) {
  Cluster cluster = day();
  cluster.nodes = 8;
  std::string text = job_script(cluster, pack());
  EXPECT_THAT(text, AllOf(HasSubstr("#SBATCH --ntasks=3\n"), HasSubstr("#SBATCH --nodes=3\n"),
                          HasSubstr("points/a/attempts/1/job.log"), HasSubstr("keys=(a b c)\nattempts=(1 2 3)"),
                          HasSubstr("launcher=(srun --mpi=pmix --exact -n 1 --mem=0)")));
  cluster.memory_per_rank_MiB = 100;  // then each step takes its share, and no --mem=0 is due
  EXPECT_THAT(job_script(cluster, pack()), HasSubstr("launcher=(srun --mpi=pmix --exact -n 1)"));
}

TEST(JobScriptText, LauncherIsWhatTheClusterFileSays) {
  Cluster cluster = day();
  cluster.mpi = "";
  EXPECT_THAT(job_script(cluster, one_point()), HasSubstr("launcher=(srun --exact -n 4"));
  cluster.launcher = "mpirun";
  EXPECT_THAT(job_script(cluster, one_point()), HasSubstr("launcher=(mpirun -n 4)\n"));
  EXPECT_THAT(job_script(cluster, pack()), HasSubstr("launcher=()\n"));
  JobScript wide = pack();
  wide.ranks = 2;
  EXPECT_THAT(job_script(cluster, wide), HasSubstr("launcher=(mpirun -n 2 --bind-to none)\n"));
}

TEST(JobScriptText, CommandAtTheEndTakesAMinuteOfTheTimeLimit) {
  JobScript job = one_point();
  job.at_end = {"/opt/bin/rouleau", "sync", "--quiet", "/data/a sweep"};
  EXPECT_THAT(job_script(day(), job), AllOf(HasSubstr("\nat_end=(/opt/bin/rouleau sync --quiet '/data/a sweep')\n"),
                                            HasSubstr("\nmargin_s=60\n")));
}

TEST(JobScriptText, PathsOfAnyLettersAreOneWordForTheShellAndForSbatch) {
  JobScript job = one_point();
  job.campaign = "/data/it's $(touch x) `id` \"%j\" ü";
  const std::string text = job_script(day(), job);
  EXPECT_THAT(text, HasSubstr("#SBATCH --output=\"/data/it's $(touch x) `id` \\\"%%j\\\" ü/points/0123abcd/"));
  EXPECT_THAT(text, HasSubstr("campaign='/data/it'\\''s $(touch x) `id` \"%j\" ü'\n"));
}

TEST(JobScriptText, WhatNoLineCanCarryIsRefused) {
  for (const char* path : {"/data/a\nb", "/data/a\\b", "/data/a\tb", "/data/\x7f"}) {
    JobScript job = one_point();
    job.campaign = path;
    EXPECT_THROW(static_cast<void>(job_script(day(), job)), Error) << path;
    job = one_point();
    job.solver = path;
    EXPECT_THROW(static_cast<void>(job_script(day(), job)), Error) << path;
    job = one_point();
    job.at_end = {"rouleau", path};
    EXPECT_THROW(static_cast<void>(job_script(day(), job)), Error) << path;
  }
  Cluster cluster = day();
  cluster.sbatch = {"--comment=a\nrm -rf x"};
  EXPECT_THROW(static_cast<void>(job_script(cluster, one_point())), Error);
  cluster.sbatch.clear();
  cluster.setup = {"true\nfalse"};
  EXPECT_THROW(static_cast<void>(job_script(cluster, one_point())), Error);
  JobScript job = one_point();
  job.points.front().key = "../x";
  EXPECT_THROW(static_cast<void>(job_script(day(), job)), std::logic_error);
  job = one_point();
  job.name = "a b";
  EXPECT_THROW(static_cast<void>(job_script(day(), job)), std::logic_error);
}

TEST(JobScriptText, QuotedWordsComeBackFromAShellAsTheyWere) {
  for (const std::string text : {"", "plain", "a b", "it's", "''", "$(id) `id` $HOME", "\"x\"", "a\nb", "*", "~", "\\",
                                 "-n", "\xff\xfe", "!x", "a;b&c|d>e"}) {
    const Capture capture = run_and_capture({"bash", "-c", "printf %s " + shell_quoted(text)});
    EXPECT_EQ(capture.out, text);
  }
}

TEST(JobScriptText, BashReadsIt) {
  Cluster cluster = day();
  cluster.setup = {"true"};
  const rouleau::testing::TemporaryDirectory place;
  rouleau::testing::set_content(place.path() / "job.sh", job_script(cluster, pack()));
  EXPECT_EQ(run_and_capture({"bash", "-n", (place.path() / "job.sh").string()}).err, "");
}

TEST(JobScriptText, ShellcheckFindsNothing) {
  if (run_and_capture({"sh", "-c", "command -v shellcheck"}).status != 0) GTEST_SKIP() << "shellcheck is not installed";
  const rouleau::testing::TemporaryDirectory place;
  rouleau::testing::set_content(place.path() / "job.sh", job_script(day(), pack()));
  const Capture capture = run_and_capture({"shellcheck", (place.path() / "job.sh").string()});
  EXPECT_EQ(capture.out, "");
}

}  // namespace
}  // namespace rouleau::campaign
