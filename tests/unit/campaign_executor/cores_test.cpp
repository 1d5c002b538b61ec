// SPDX-License-Identifier: BSD-3-Clause
// Counting cores.
#include "executor/cores.hpp"

#include <gmock/gmock.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace rouleau::campaign {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(CampaignCores, OfThisProcessAreSome) {
  EXPECT_FALSE(allowed_cores().empty());
  EXPECT_EQ(cores_of(::getpid()), allowed_cores());
  EXPECT_THAT(cores_of(-1), IsEmpty());
}

TEST(CampaignCores, PinnedJobsTakeTheirs) {
  EXPECT_THAT(free_cores({0, 1, 2, 3}, {{{1}, 1}, {{3}, 1}}), ElementsAre(0, 2));
  EXPECT_THAT(free_cores({0, 1, 2, 3}, {{{0, 1, 2, 3}, 4}}), IsEmpty());
}

TEST(CampaignCores, UnpinnedJobsTakeAsManyAsTheyHaveRanks) {
  EXPECT_THAT(free_cores({0, 1, 2, 3}, {{{0, 1, 2, 3}, 1}}), ElementsAre(0, 1, 2));
  EXPECT_THAT(free_cores({0, 1}, {{{0, 1, 2, 3}, 3}}), IsEmpty());
}

TEST(CampaignCores, JobsElsewhereDoNotMatter) { EXPECT_THAT(free_cores({0, 1}, {{{7}, 1}}), ElementsAre(0, 1)); }

TEST(CampaignCores, DeadOccupantTakesNothing) { EXPECT_THAT(free_cores({0, 1}, {{{}, 1}}), ElementsAre(0, 1)); }

TEST(CampaignCores, ThatOthersArePinnedToComeLast) {
  EXPECT_THAT(quiet_first({0, 1, 2, 3}, {0, 2}), ElementsAre(1, 3, 0, 2));
  EXPECT_THAT(quiet_first({0, 1}, {0, 1, 7}), ElementsAre(0, 1));
}

TEST(CampaignCores, OfSolversOfOtherCampaignsAreSeen) {
  if (allowed_cores().size() < 2) GTEST_SKIP() << "a machine of one core: nothing can be pinned";
  const int core = allowed_cores().back();
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    ::prctl(PR_SET_NAME, "rouleau-solver");
    const char is_pinned = pin_to({core}) ? 'y' : 'n';
    (void)!::write(ready[1], &is_pinned, 1);
    ::pause();
  }
  char is_pinned = 0;
  EXPECT_EQ(::read(ready[0], &is_pinned, 1), 1);
  EXPECT_EQ(is_pinned, 'y');
  EXPECT_THAT(cores_of_solvers(), Contains(core));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  for (const int end : ready) ::close(end);
}

TEST(CampaignCores, AreWrittenWithCommas) {
  EXPECT_EQ(to_text({0, 1, 5}), "0,1,5");
  EXPECT_EQ(to_text({}), "");
}

}  // namespace
}  // namespace rouleau::campaign
