// SPDX-License-Identifier: BSD-3-Clause
// A job script compares what a run reads with its sums before each start.
#include <gmock/gmock.h>

#include "job_script_run.hpp"
#include "study/input_files.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::content_of;
using rouleau::testing::set_content;
using ::testing::HasSubstr;

// The manager looks at the submission; a queue may hold the job for days after that.
TEST_F(JobScriptRun, PointWhoseInputFilesHaveChangedIsLeftAloneAndTheOthersRun) {
  const std::string mesh = "files/cell of  $(touch hacked) `id`-0123abcd.off";
  std::filesystem::create_directory(campaign_ / "files");
  set_content(campaign_ / mesh, "OFF\n");
  for (const std::string key : {"a", "b", "c", "d"}) {
    add_point(key, "exit 0");
    const std::filesystem::path run = campaign_ / "points" / key;
    set_content(run / "run.ini", "[cell]\nmesh_file = ../../" + mesh + "\n");
    set_content(run / "inputs", input_sums(run));
  }
  const auto run_file = [&](const std::string& key) { return campaign_ / "points" / key / "run.ini"; };
  set_content(run_file("b"), content_of(run_file("b")) + "# edited\n");
  std::filesystem::remove(run_file("c"));
  EXPECT_EQ(run(), 65);
  for (const char* key : {"a", "d"}) EXPECT_EQ(content_of(attempt(key, 1) / "status"), "0\n") << key;
  for (const char* key : {"b", "c"}) {
    EXPECT_EQ(content_of(attempt(key, 1) / "status"), "65\n") << key;
    EXPECT_FALSE(std::filesystem::exists(attempt(key, 1) / "arguments")) << "the solver was started on " << key;
    EXPECT_EQ(
        last_line(attempt(key, 1) / "stderr"),
        "job.sh: " + run_file(key).string() + " is not the file that `rouleau init` wrote; the solver was not started");
    EXPECT_THAT(log(), HasSubstr("point " + std::string(key) + ": run.ini is not the file"));
  }
  EXPECT_FALSE(std::filesystem::exists(campaign_ / "points/a/hacked"));

  // Slurm starts the job again after the mesh was damaged.
  set_content(campaign_ / mesh, "OFX\n");
  ::setenv("SLURM_RESTART_COUNT", "1", 1);
  EXPECT_EQ(run(), 65);
  EXPECT_EQ(content_of(attempt("a", 2) / "status"), "65\n");
  EXPECT_THAT(content_of(attempt("a", 2) / "stderr"), HasSubstr(mesh + " is not the file"));
}

TEST_F(JobScriptRun, NodeWithoutCksumSaysSoAndGoesOn) {
  add_point("a", "exit 0");
  set_content(campaign_ / "points/a/run.ini", "[fluid]\nlambda = 5\n");
  set_content(campaign_ / "points/a/inputs", "1 1 run.ini\n");
  cluster_.setup = {"command() { [ \"$2\" != cksum ] && builtin command \"$@\"; }"};
  EXPECT_EQ(run(), 0);
  EXPECT_EQ(content_of(attempt("a", 1) / "status"), "0\n");
  EXPECT_THAT(log(), HasSubstr("point a: there is no program cksum here; its input files are not compared"));
}

}  // namespace
}  // namespace rouleau::campaign
