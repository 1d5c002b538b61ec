// SPDX-License-Identifier: BSD-3-Clause
// A file that a study names is copied by `init`; a copy that was damaged is not run.
#include <gmock/gmock.h>

#include "support/campaign_outcome.hpp"
#include "support/campaign_program.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using rouleau::testing::content_of;
using rouleau::testing::set_content;
using ::testing::HasSubstr;

// It was compared with nothing: a vertex elsewhere was run as if the study had said so, and `init` left it as it was.
TEST(DamagedMesh, IsNotRunAndInitWritesItAnew) {
  const CampaignProgram program;
  const std::string sound = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  set_content(program.path() / "cell of mine.off", sound);
  program.write_study("fluid.lambda = 1, 5",
                      CampaignProgram::execution("retries = 0\n") + "[cell]\nmesh_file = cell of mine.off\n");
  ASSERT_EQ(program.init().status, 0);
  const std::filesystem::path copy = std::filesystem::directory_iterator(program.campaign() / "files")->path();
  std::string moved = sound;
  moved[moved.find("1 0 0")] = '2';  // still a tetrahedron
  set_content(copy, moved);
  const auto expect_refused = [&](const std::string& problem) {
    const auto refused = program.run();
    EXPECT_EQ(refused.status, 4) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr(copy.filename().string() + ": is " + problem));
    EXPECT_THAT(refused.err, HasSubstr("`rouleau init STUDY DIR` copies it again from the study's own file"));
    EXPECT_FALSE(std::filesystem::exists(program.run_directory(1) / "samples.csv"));
    const auto verified = program.rouleau({"verify", "c"});
    EXPECT_EQ(verified.status, 7);
    EXPECT_THAT(verified.out, HasSubstr(copy.filename().string() + ": is " + problem));
  };
  const auto expect_mended = [&] {
    EXPECT_EQ(program.init().status, 0);
    EXPECT_EQ(content_of(copy), sound);
    EXPECT_EQ(program.rouleau({"retry", "--all-failed", "-C", "c"}).status, 0);
  };
  expect_refused("not the file that `rouleau init` copied");
  expect_mended();
  std::filesystem::remove(copy);
  expect_refused("missing");
  expect_mended();

  set_content(program.run_directory(1) / "inputs", "1 2 run.ini\n");
  EXPECT_THAT(program.rouleau({"verify", "c"}).out, HasSubstr("inputs: the sums in it are not those of run.ini"));
  EXPECT_EQ(program.init().status, 0);
  const auto finished = program.run();
  EXPECT_EQ(finished.status, 0) << finished.err;
  EXPECT_EQ(program.rouleau({"verify", "c"}).status, 0);
}

}  // namespace
}  // namespace rouleau::campaign
