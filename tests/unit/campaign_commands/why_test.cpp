// SPDX-License-Identifier: BSD-3-Clause
// `rouleau why` after ends of each kind: what it shows is what the run directory proves.
#include <gmock/gmock.h>

#include "support/campaign_program.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(CampaignWhy, ShowsTheEvidenceOfACrashAFailureAndAFileError) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1, 2, 3", CampaignProgram::execution("retries = 1\n"));
  ASSERT_EQ(program.init().status, 0);
  program.script(1, "crash 70\n-\n");
  program.script(2, "exit 70 20\n");
  program.script(3, "exit 74 20\n-\n");
  EXPECT_EQ(program.run().status, 4);
  const auto why = [&](const char* point) { return program.rouleau({"why", point, "-C", "c"}).out; };
  EXPECT_THAT(why("#1"),
              AllOf(HasSubstr("attempt 1: its process is gone and left no exit.json"),
                    HasSubstr("it reached checkpoint 50, so it goes on"), HasSubstr("attempt 2: exit.json says 0")));
  EXPECT_THAT(why("#2"), HasSubstr("attempt 1: exit.json says 70 (scripted end at step 20) at step 20"));
  EXPECT_THAT(why("#3"), AllOf(HasSubstr("attempt 1: exit.json says 74 (scripted end at step 20) at step 20"),
                               HasSubstr("not counted as a retry"), HasSubstr("attempt 2: exit.json says 0")));
}

}  // namespace
}  // namespace rouleau::campaign
