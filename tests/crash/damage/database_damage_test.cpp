// SPDX-License-Identifier: BSD-3-Clause
// A damaged or lost database: `verify` says so, `rebuild` makes it what it was, from the run directories alone.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "crash/damage/figures.hpp"
#include "crash/damage/real_campaign.hpp"
#include "study/error.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignOutcome;
using rouleau::testing::content_of;
using rouleau::testing::figures;
using rouleau::testing::RealCampaign;
using rouleau::testing::set_content;

class DamagedDatabase : public ::testing::Test {
 protected:
  DamagedDatabase() {
    program_.finish();
    sound_ = outcome_of(program_);
  }
  [[nodiscard]] std::filesystem::path file() const { return program_.campaign() / "campaign.db"; }

  [[nodiscard]] bool is_as_before() const {
    try {
      return outcome_of(program_) == sound_;
    } catch (const Error&) {
      return false;
    }
  }
  void expect_rebuilt(const std::string& what) const {
    const auto rebuilt = program_.rouleau({"rebuild", "c"});
    EXPECT_EQ(rebuilt.status, 0) << what << ": " << rebuilt.err;
    EXPECT_TRUE(is_as_before()) << what;
    figures().wrong_resumes += is_as_before() ? 0 : 1;
  }

  RealCampaign program_;
  CampaignOutcome sound_;
};

TEST_F(DamagedDatabase, AnywhereIsFoundOrHarmlessAndRebuiltAsItWas) {
  const std::string sound = content_of(file());
  const int count = rouleau::testing::places(10, 150);
  for (int i = 0; i < count; ++i) {
    const std::size_t place = rouleau::testing::spread(i, sound.size());
    const std::string what = fmt::format("place {}, kind {}", place, i % 5);
    set_content(file(), rouleau::testing::damaged(sound, place, i));
    ++figures().damage_positions;
    for (const char* verb : {"status", "query", "verify"}) {
      const auto answer = program_.rouleau({verb, "c"});
      EXPECT_LT(answer.status, 8) << what << ": " << verb << " died: " << answer.err;
      if (answer.status != 0) {
        EXPECT_NE(answer.err + answer.out, "") << what << ": " << verb << " says nothing";
      }
      const bool is_missed = std::string(verb) == "verify" && answer.status == 0 && !is_as_before();
      figures().undetected += is_missed ? 1 : 0;
      EXPECT_FALSE(is_missed) << what;
    }
    expect_rebuilt(what);
  }
}

TEST_F(DamagedDatabase, LostIsRebuiltAsItWas) {
  std::filesystem::remove(file());
  expect_rebuilt("lost");
  const auto checked = program_.rouleau({"verify", "c"});
  EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
}

}  // namespace
}  // namespace rouleau::campaign
