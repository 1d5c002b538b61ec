// SPDX-License-Identifier: BSD-3-Clause
// The cluster file: what it means, and what each wrong line is answered with.
#include "study/cluster.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <random>

#include "study/error.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::campaign {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Cluster parsed(const std::string& text) { return parse_cluster(text, "somewhere/cluster.ini"); }

TEST(ClusterFile, TimeLimitAloneIsEnough) {
  const Cluster cluster = parsed("time_limit = 24:00:00\n");
  EXPECT_EQ(cluster.time_limit_s, 86400);
  EXPECT_EQ(cluster.launcher, "srun");
  EXPECT_EQ(cluster.mpi, "pmix");
  EXPECT_EQ(cluster.partition, "");
  EXPECT_EQ(cluster.points_per_job, 1);
  EXPECT_TRUE(cluster.sbatch.empty());
}

TEST(ClusterFile, EveryKeyIsTaken) {
  const Cluster cluster = parsed(
      "[cluster]\npartition = a,b\naccount = p-1\nqos = high\ntime_limit = 90\npoints_per_job = 48\nnodes = 2\n"
      "ranks = 3\nmemory_per_rank_MiB = 500\nmpi = default\njobs = 7\nsubmissions_per_pass = 8\npoll_s = 9.5\n"
      "patience_min = 10\nclient_timeout_s = 11\nsignal_s = 0\nrequeue = 0\n");
  EXPECT_EQ(cluster.partition, "a,b");
  EXPECT_EQ(cluster.account, "p-1");
  EXPECT_EQ(cluster.qos, "high");
  EXPECT_EQ(cluster.time_limit_s, 5400);
  EXPECT_EQ(cluster.points_per_job, 48);
  EXPECT_EQ(cluster.nodes, 2);
  EXPECT_EQ(cluster.ranks, 3);
  EXPECT_EQ(cluster.memory_per_rank_MiB, 500);
  EXPECT_EQ(cluster.mpi, "");
  EXPECT_EQ(cluster.jobs, 7);
  EXPECT_EQ(cluster.submissions_per_pass, 8);
  EXPECT_EQ(cluster.poll_s, 9.5);
  EXPECT_EQ(cluster.patience_min, 10);
  EXPECT_EQ(cluster.client_timeout_s, 11);
  EXPECT_EQ(cluster.signal_s, 0);
  EXPECT_EQ(cluster.requeue, 0);
}

TEST(ClusterFile, RepeatedKeysKeepTheirOrderAndSetupKeepsItsHashes) {
  const Cluster cluster = parsed(
      "time_limit = 1:00:00  # an hour\r\nsbatch = --exclusive  # the whole node\nsetup = module load a # now\n"
      "sbatch = -C fast\nsetup = export X=\"a=b#c\"\n");
  EXPECT_THAT(cluster.sbatch, ElementsAre("--exclusive", "-C fast"));
  EXPECT_THAT(cluster.setup, ElementsAre("module load a # now", "export X=\"a=b#c\""));
}

TEST(ClusterFile, TimesAreReadAsSbatchReadsThem) {
  EXPECT_EQ(seconds_of_time_limit("90"), 5400);
  EXPECT_EQ(seconds_of_time_limit("10:30"), 630);
  EXPECT_EQ(seconds_of_time_limit("24:00:00"), 86400);
  EXPECT_EQ(seconds_of_time_limit("2-00:00:00"), 2 * 86400);
  EXPECT_EQ(seconds_of_time_limit("1-12"), 1.5 * 86400);
  EXPECT_EQ(seconds_of_time_limit("1-00:30"), 86400 + 1800);
  for (const char* wrong : {"", "x", "1:2:3:4", "-5", "1-", "1:", ":1", "1.5", "1h", "UNLIMITED", "99999999999"}) {
    EXPECT_LT(seconds_of_time_limit(wrong), 0) << wrong;
  }
}

struct Bad {
  const char* what;
  std::string text;
  std::vector<std::string> parts;  ///< of the message
};

const std::string hour = "time_limit = 60\n";

const std::vector<Bad> bad_clusters = {
    {"Empty", "", {"cluster.ini: has no time limit", "time_limit = 24:00:00"}},
    {"Section", "[slurm]\n", {"cluster.ini:1:", "[slurm]", "[cluster]"}},
    {"NoEquals", hour + "partition debug\n", {"cluster.ini:2:", "`partition debug`", "name = value"}},
    {"NoName", hour + "= 5\n", {"cluster.ini:2:", "no name"}},
    {"NoValue", hour + "partition =\n", {"cluster.ini:2:", "`partition` has no value"}},
    {"ValueIsComment", hour + "partition = # x\n", {"cluster.ini:2:", "`partition` has no value"}},
    {"UnknownKey", hour + "partitoin = x\n", {"cluster.ini:2:", "`partitoin`", "Did you mean `partition`?"}},
    {"FarKey", hour + "lambda = 5\n", {"cluster.ini:2:", "time_limit, partition", "setup"}},
    {"Twice", hour + "jobs = 1\njobs = 2\n", {"cluster.ini:3:", "`jobs`", "line 2"}},
    {"TimeTwice", hour + hour, {"cluster.ini:2:", "`time_limit`", "line 1"}},
    {"TimeIsNone", "time_limit = soon\n", {"cluster.ini:1:", "soon", "2-00:00:00"}},
    {"TimeUnlimited", "time_limit = UNLIMITED\n", {"cluster.ini:1:", "UNLIMITED"}},
    {"TimeTooShort", "time_limit = 0:59\n", {"cluster.ini:1:", "59 s", "a minute to 366 days"}},
    {"TimeTooLong", "time_limit = 367-0\n", {"cluster.ini:1:", "366 days"}},
    {"NotANumber", hour + "jobs = many\n", {"cluster.ini:2:", "jobs = many is not a number"}},
    {"NotWhole", hour + "nodes = 1.5\n", {"cluster.ini:2:", "whole number from 1 to 10000"}},
    {"TooMany", hour + "points_per_job = 10001\n", {"cluster.ini:2:", "points_per_job = 10001", "1 to 10000"}},
    {"Negative", hour + "ranks = -1\n", {"cluster.ini:2:", "ranks = -1"}},
    {"Huge", hour + "memory_per_rank_MiB = 1e300\n", {"cluster.ini:2:", "memory_per_rank_MiB"}},
    {"Launcher", hour + "launcher = srum\n", {"cluster.ini:2:", "srum", "Did you mean `srun`?"}},
    {"WordWithBlank", hour + "partition = a b\n", {"cluster.ini:2:", "partition = a b"}},
    {"WordIsOption", hour + "account = --uid=0\n", {"cluster.ini:2:", "account = --uid=0"}},
    {"WordIsShell", hour + "qos = $(id)\n", {"cluster.ini:2:", "qos = $(id)"}},
    {"SbatchIsNoOption", hour + "sbatch = exclusive\n", {"cluster.ini:2:", "does not begin with `-`"}},
    {"SbatchTime", hour + "sbatch = --time=5\n", {"cluster.ini:2:", "--time=5", "time_limit = ..."}},
    {"SbatchShortTime", hour + "sbatch = -t5\n", {"cluster.ini:2:", "-t5", "time_limit = ..."}},
    {"SbatchAbbreviated", hour + "sbatch = --part=x\n", {"cluster.ini:2:", "--part=x", "partition = ..."}},
    {"SbatchSecondWord", hour + "sbatch = --exclusive -J x\n", {"cluster.ini:2:", "-J", "sets it itself"}},
    {"SbatchArray", hour + "sbatch = --array=1-5\n", {"cluster.ini:2:", "points_per_job"}},
    {"SbatchWait", hour + "sbatch = -W\n", {"cluster.ini:2:", "does not wait"}},
    {"ControlCharacter",
     hour + "setup = a\x01"
            "b\n",
     {"cluster.ini:2:", "control character"}},
    {"ZeroByte", hour + std::string("sbatch = -x\0y\n", 14), {"cluster.ini:2:", "control character"}},
    {"SignalTooEarly", "time_limit = 2:00\nsignal_s = 120\n", {"cluster.ini:2:", "signal_s = 120", "120 s"}},
    {"SignalTooEarlyByDefault", "time_limit = 1\n", {"cluster.ini:1:", "signal_s = 120", "60 s"}},
    {"PacksOfMpirunOnManyNodes",
     hour + "launcher = mpirun\nnodes = 2\npoints_per_job = 8\n",
     {"cluster.ini:3:", "first node", "launcher = srun"}},
    {"TooManyTasks", hour + "points_per_job = 10000\nranks = 1000\n", {"cluster.ini:2:", "1000000 tasks"}},
};

class BadClusterFiles : public ::testing::TestWithParam<Bad> {};

TEST_P(BadClusterFiles, IsOneLineThatSaysWhatAndWhere) {
  try {
    static_cast<void>(parsed(GetParam().text));
    FAIL() << "taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::usage);
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos);
    for (const std::string& part : GetParam().parts) EXPECT_THAT(message, HasSubstr(part));
  }
}

INSTANTIATE_TEST_SUITE_P(All, BadClusterFiles, ::testing::ValuesIn(bad_clusters),
                         [](const auto& bad) { return std::string(bad.param.what); });

TEST(ClusterFile, OptionsThatOnlyLookLikeOursAreTaken) {
  for (const char* option : {"--exclusive", "--ntasks-per-node=4", "--mem-per-gpu=1G", "--wait-all-nodes=1",
                             "--time-min=10", "--cpus-per-task=2", "-C fast", "--dependency=singleton", "-x n1"}) {
    EXPECT_THAT(parsed(hour + "sbatch = " + option + "\n").sbatch, ElementsAre(option));
  }
}

TEST(ClusterFile, MissingFileAndDirectoryAreToldApart) {
  const rouleau::testing::TemporaryDirectory place;
  try {
    static_cast<void>(read_cluster(place.path() / "cluster.ini"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::not_found);
    EXPECT_THAT(error.what(), HasSubstr("--help-cluster"));
  }
  try {
    static_cast<void>(read_cluster(place.path()));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::usage);
  }
}

TEST(ClusterFile, FileThatIsNoneIsNotReadToItsEnd) {
  EXPECT_THROW(static_cast<void>(read_cluster("/dev/zero")), Error);  // it has none: reading stops at a limit
}

TEST(ClusterFile, AnyBytesAreAnErrorOrACluster) {
  // Fixed seed: pieces of good files and single bytes in any order. Nothing else than Error may come out.
  const std::vector<std::string> pieces = {"time_limit", "=",  " ",    "\n",    "90",  "sbatch",  "setup",
                                           "--",         "-",  "#",    "[",     "]",   "cluster", "jobs",
                                           "1e308",      "\0", "\xff", "ranks", "1/0", "nan",     ":"};
  std::mt19937 random(7);
  for (int i = 0; i < 20000; ++i) {
    std::string text;
    for (unsigned n = random() % 12; n > 0; --n) text += pieces[random() % pieces.size()];
    try {
      EXPECT_GE(parsed(text).time_limit_s, 60);
    } catch (const Error&) {
    }
  }
}

TEST(ClusterFile, HelpNamesEveryKeyWithItsDefault) {
  const std::string help = cluster_help();
  for (const char* key : {"time_limit", "partition", "account", "qos", "launcher", "mpi", "points_per_job", "nodes",
                          "ranks", "memory_per_rank_MiB", "jobs", "submissions_per_pass", "poll_s", "patience_min",
                          "client_timeout_s", "signal_s", "requeue", "sbatch", "setup"}) {
    EXPECT_THAT(help, HasSubstr("    " + std::string(key) + " ")) << key;
  }
  EXPECT_THAT(help, HasSubstr("signal_s             = 120"));
  EXPECT_THAT(help, HasSubstr("[0 ... 65535]"));
}

TEST(ClusterFile, TemplatesAreGoodAndTheGenericOneShowsEveryKeyWithItsDefault) {
  const std::filesystem::path templates = CLUSTER_TEMPLATES;
  for (const char* name : {"generic.ini", "packed-nodes.ini", "small.ini"}) {
    EXPECT_NO_THROW(static_cast<void>(read_cluster(templates / name))) << name;
  }
  EXPECT_EQ(read_cluster(templates / "packed-nodes.ini").points_per_job, 48);

  const std::string generic = rouleau::testing::content_of(templates / "generic.ini");
  // The help's lines of keys are "    name ... = default  # meaning".
  std::istringstream help(cluster_help());
  std::string line;
  int keys = 0;
  while (std::getline(help, line)) {
    std::istringstream words(line);
    std::string key, equals;
    if (!line.starts_with("    ") || !(words >> key >> equals) || equals != "=") continue;
    EXPECT_TRUE(generic.find("\n" + key + " ") != std::string::npos ||
                generic.find("\n# " + key + " ") != std::string::npos)
        << key;
    ++keys;
  }
  EXPECT_EQ(keys, 19);
  const Cluster shown = read_cluster(templates / "generic.ini"), defaults;
  EXPECT_EQ(shown.jobs, defaults.jobs);
  EXPECT_EQ(shown.submissions_per_pass, defaults.submissions_per_pass);
  EXPECT_EQ(shown.poll_s, defaults.poll_s);
  EXPECT_EQ(shown.patience_min, defaults.patience_min);
  EXPECT_EQ(shown.client_timeout_s, defaults.client_timeout_s);
  EXPECT_EQ(shown.signal_s, defaults.signal_s);
  EXPECT_EQ(shown.requeue, defaults.requeue);
  EXPECT_EQ(shown.mpi, defaults.mpi);
}

}  // namespace
}  // namespace rouleau::campaign
