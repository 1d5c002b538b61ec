// SPDX-License-Identifier: BSD-3-Clause
// A damaged sample log: the run goes back to a checkpoint that counts only what is sound, or says why it cannot.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>

#include "crash/damage/figures.hpp"
#include "crash/damage/three_generations.hpp"

namespace rouleau::testing {
namespace {

using ::testing::HasSubstr;

class DamagedLog : public ::testing::Test {
 protected:
  /// Runs with this log. The generation it must go on from is the newest that counts no byte behind the first change.
  void expect_recovered_or_refused(const std::string& bytes, const std::string& what) {
    generations_.put_back();
    set_content(run_.path("samples.csv"), bytes);
    const Finished finished = run_.run();
    ++figures().damage_positions;
    const std::string& sound = generations_.sound("samples.csv");
    const auto common = std::min(sound.size(), bytes.size());
    const auto first_change = static_cast<std::size_t>(
        std::mismatch(sound.begin(), sound.begin() + static_cast<std::ptrdiff_t>(common), bytes.begin()).first -
        sound.begin());
    int expected = 2;
    while (expected >= 0 && generations_.counted(expected) > first_change) --expected;
    if (expected < 0) {
      figures().undetected += finished.code == 65 ? 0 : 1;
      EXPECT_EQ(finished.code, 65) << what;
      EXPECT_THAT(finished.err, HasSubstr("samples.csv")) << what;
      EXPECT_EQ(run_.samples(), bytes) << what << ": what is left of the log must not be touched";
      return;
    }
    const bool is_right = finished.code == 0 && generations_.has_the_same_end();
    figures().wrong_resumes += is_right ? 0 : 1;
    EXPECT_TRUE(is_right) << what << ": " << finished.err;
    const bool is_detected = run_.exit_record().at("resumed_from") == generations_.checkpoint(expected);
    figures().undetected += is_detected ? 0 : 1;
    EXPECT_TRUE(is_detected) << what << ": " << finished.err;
  }

  ThreeGenerations generations_;
  SmallRun& run_ = generations_.run;
};

TEST_F(DamagedLog, AnywhereIsRecoveredOrRefused) {
  const std::string sound = generations_.sound("samples.csv");
  const int count = places(25, 300);
  for (int i = 0; i < count; ++i) {
    const std::size_t place = spread(i, sound.size());
    expect_recovered_or_refused(damaged(sound, place, i), fmt::format("place {}, kind {}", place, i % 5));
  }
}

TEST_F(DamagedLog, WithLostOrForeignLinesIsRecoveredOrRefused) {
  const std::string sound = generations_.sound("samples.csv");
  const std::size_t last = sound.rfind('\n', sound.size() - 2) + 1, before = sound.rfind('\n', last - 2) + 1;
  const std::string last_line = sound.substr(last);
  expect_recovered_or_refused(sound.substr(0, last), "last line lost");
  expect_recovered_or_refused(sound.substr(0, sound.size() - 1), "last newline lost");
  expect_recovered_or_refused(sound.substr(0, before) + last_line, "a line lost");
  expect_recovered_or_refused(sound + last_line, "last line repeated");
  expect_recovered_or_refused(sound + last_line.substr(0, 30), "a torn line more");
  expect_recovered_or_refused(sound + std::string(4096, '\0'), "a page of zeros more");
  expect_recovered_or_refused(sound.substr(sound.find('\n') + 1), "header lost");
  expect_recovered_or_refused("", "nothing left");
}

}  // namespace
}  // namespace rouleau::testing
