// SPDX-License-Identifier: BSD-3-Clause
// point.json and whole files.
#include "study/point.hpp"

#include <gmock/gmock.h>

#include "study/error.hpp"
#include "study/whole_file.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::campaign {
namespace {

Point some_point() {
  Point point;
  point.key = "0123456789ab";
  point.identity = "0123456789abcdef0123456789abcdef";
  point.ordinal = 3;
  point.replica = 2;
  point.in_study = false;
  point.cancelled = true;
  point.swept = {"fluid.lambda", "cell.replica"};
  point.parameters = {{"fluid.lambda", "4.75", true, true}, {"time.end_time_s", "0.2", false, false}};
  point.facts = {144000, 1.0 / 3.0, 0.2, 20400, 1440, 3500000, 7, 40000.5};
  return point;
}

TEST(CampaignPoint, SurvivesItsFile) {
  const rouleau::testing::TemporaryDirectory directory;
  const Point before = some_point();
  write_point(directory.path() / "point.json", before);
  const Point after = read_point(directory.path() / "point.json");
  EXPECT_EQ(after.key, before.key);
  EXPECT_EQ(after.identity, before.identity);
  EXPECT_EQ(after.ordinal, before.ordinal);
  EXPECT_EQ(after.replica, before.replica);
  EXPECT_EQ(after.in_study, before.in_study);
  EXPECT_EQ(after.cancelled, before.cancelled);
  EXPECT_EQ(after.swept, before.swept);
  ASSERT_EQ(after.parameters.size(), before.parameters.size());
  EXPECT_EQ(*after.find("fluid.lambda"), "4.75");
  EXPECT_FALSE(after.parameters[1].is_identity);
  EXPECT_FALSE(after.parameters[1].is_given);
  EXPECT_EQ(after.facts.time_step_us, before.facts.time_step_us);  // shortest round-trip text: the same bits
  EXPECT_EQ(after.facts.relative_cost_per_step, before.facts.relative_cost_per_step);
  EXPECT_EQ(after.facts.checkpoint_bytes, before.facts.checkpoint_bytes);
}

TEST(CampaignPoint, DamageNamesTheFileAndTheRemedy) {
  const rouleau::testing::TemporaryDirectory directory;
  const auto file = directory.path() / "point.json";
  for (const char* text : {"", "{", "{\"key\": 3}"}) {
    write_whole_file(file, text);
    try {
      static_cast<void>(read_point(file));
      FAIL() << "was taken: " << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Exit::damaged);
      EXPECT_THAT(error.what(),
                  ::testing::AllOf(::testing::HasSubstr(file.string()), ::testing::HasSubstr("rouleau init")));
    }
  }
}

TEST(CampaignPoint, IsLabelledByWhatIsSwept) {
  Point point = some_point();
  point.swept = {"fluid.lambda"};
  EXPECT_EQ(point.label(), "fluid.lambda = 4.75");
  point.swept.clear();
  EXPECT_EQ(point.label(), point.key);
}

TEST(CampaignWholeFile, LeavesNothingBesideItself) {
  const rouleau::testing::TemporaryDirectory directory;
  write_whole_file(directory.path() / "a", "one");
  write_whole_file(directory.path() / "a", "two");
  EXPECT_EQ(read_whole_file(directory.path() / "a"), "two");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory.path()), {}), 1);
  EXPECT_FALSE(read_whole_file(directory.path() / "b").has_value());
}

TEST(CampaignWholeFile, IsNotReadBeyondItsLimit) {
  const rouleau::testing::TemporaryDirectory directory;
  write_whole_file(directory.path() / "a", "1234");
  EXPECT_EQ(read_whole_file(directory.path() / "a", 4), "1234");
  EXPECT_THROW(static_cast<void>(read_whole_file(directory.path() / "a", 3)), Error);
  EXPECT_THROW(static_cast<void>(read_whole_file("/dev/zero", 100)), Error) << "it has no end";
}

TEST(CampaignWholeFile, FailureKeepsTheOldFile) {
  const rouleau::testing::TemporaryDirectory directory;
  write_whole_file(directory.path() / "a", "one");
  std::filesystem::create_directory(directory.path() / "a.tmp");  // in the way of the file written aside
  EXPECT_THROW(write_whole_file(directory.path() / "a", "two"), Error);
  EXPECT_EQ(read_whole_file(directory.path() / "a"), "one");
}

}  // namespace
}  // namespace rouleau::campaign
