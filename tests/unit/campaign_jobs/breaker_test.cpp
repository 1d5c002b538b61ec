// SPDX-License-Identifier: BSD-3-Clause
// The circuit breaker.
#include "jobs/breaker.hpp"

#include <gtest/gtest.h>

namespace rouleau::campaign {
namespace {

TEST(CampaignBreaker, TripsAtLikeFailuresOfDifferentPoints) {
  Breaker breaker(3);
  breaker.note_failure("a", "step 12: velocity is not finite at node (1, 2, 3)");
  breaker.note_failure("b", "step 4711: velocity is not finite at node (10, 20, 30)");
  EXPECT_FALSE(breaker.has_tripped());
  breaker.note_failure("c", "step 9: velocity is not finite at node (7, 7, 7)");
  EXPECT_TRUE(breaker.has_tripped());
  EXPECT_EQ(breaker.reason(), "step 9: velocity is not finite at node (7, 7, 7)");
}

TEST(CampaignBreaker, OnePointFailingAgainIsNotACommonCause) {
  Breaker breaker(2);
  for (int i = 0; i < 5; ++i) breaker.note_failure("a", "crashed");
  EXPECT_FALSE(breaker.has_tripped());
}

TEST(CampaignBreaker, AnotherReasonOrProgressBeginsAnew) {
  Breaker breaker(2);
  breaker.note_failure("a", "disk full");
  breaker.note_failure("b", "segmentation fault");
  EXPECT_FALSE(breaker.has_tripped());
  breaker.note_progress();
  breaker.note_failure("c", "segmentation fault");
  EXPECT_FALSE(breaker.has_tripped());
  breaker.note_failure("d", "segmentation fault");
  EXPECT_TRUE(breaker.has_tripped());
}

TEST(CampaignBreaker, GoesOnFromWhatWasKept) {
  Breaker first(3);
  first.note_failure("a", "step 1:\nnot finite");
  first.note_failure("b", "step 2:\nnot finite");
  Breaker next(3, first.text());
  EXPECT_EQ(next.count(), 2);
  next.note_failure("c", "step 3: not finite");
  EXPECT_TRUE(next.has_tripped());
  EXPECT_TRUE(Breaker(3, next.text()).has_tripped());
  next.reset();
  EXPECT_EQ(Breaker(3, next.text()).count(), 0);
}

// Jobs that were running meanwhile once lifted it, or changed what it said.
TEST(CampaignBreaker, OnceTrippedOnlyAResetChangesIt) {
  Breaker breaker(2);
  breaker.note_failure("a", "crashed");
  breaker.note_failure("b", "crashed");
  const std::string tripped = breaker.text();
  breaker.note_progress();
  breaker.note_failure("c", "crashed");
  breaker.note_failure("d", "disk full");
  EXPECT_TRUE(breaker.has_tripped());
  EXPECT_EQ(breaker.text(), tripped);
  breaker.reset();
  EXPECT_FALSE(breaker.has_tripped());
}

TEST(CampaignBreaker, ZeroTurnsItOff) {
  Breaker breaker(0);
  breaker.note_failure("a", "x");
  EXPECT_FALSE(breaker.has_tripped());
}

}  // namespace
}  // namespace rouleau::campaign
