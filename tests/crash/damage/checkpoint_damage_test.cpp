// SPDX-License-Identifier: BSD-3-Clause
// A damaged, torn or swapped checkpoint is named and passed over; the end is the undisturbed one or a refusal.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "crash/damage/figures.hpp"
#include "crash/damage/three_generations.hpp"
#include "storage/checksum.hpp"
#include "support/memory_file.hpp"

namespace rouleau::testing {
namespace {

using ::testing::HasSubstr;

class DamagedCheckpoint : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { generations_ = std::make_unique<ThreeGenerations>(); }
  static void TearDownTestSuite() { generations_.reset(); }
  void SetUp() override { generations_->put_back(); }

  static SmallRun& run() { return generations_->run; }
  static std::string newest() { return generations_->checkpoint(2); }

  /// The newest generation holds these bytes: it must be passed over for the one before.
  static void expect_passed_over(const std::string& bytes, const std::string& what, const std::string& why,
                                 int ranks = 1) {
    generations_->put_back();
    set_content(run().path(newest()), bytes);
    const Finished finished = run().run(ranks);
    ++figures().damage_positions;
    ASSERT_EQ(finished.code, 0) << what << ": " << finished.err;
    const nlohmann::json record = run().exit_record();
    const bool is_detected = record.at("resumed_from") == generations_->checkpoint(1);
    const bool is_right = generations_->has_the_same_end();
    figures().undetected += is_detected ? 0 : 1;
    figures().wrong_resumes += is_right ? 0 : 1;
    EXPECT_TRUE(is_detected) << what;
    EXPECT_TRUE(is_right) << what;
    ASSERT_EQ(record.at("rejected_checkpoints").size(), 1U) << what;
    const nlohmann::json& rejected = record.at("rejected_checkpoints")[0];
    EXPECT_EQ("checkpoints/" + rejected.at("file").get<std::string>(), newest()) << what;
    EXPECT_THAT(rejected.at("why").get<std::string>(), HasSubstr(why)) << what;
    EXPECT_THAT(finished.err, HasSubstr(rejected.at("file").get<std::string>() + " is rejected: ")) << what;
  }

  static std::unique_ptr<ThreeGenerations> generations_;
};
std::unique_ptr<ThreeGenerations> DamagedCheckpoint::generations_;

TEST_F(DamagedCheckpoint, AnywhereIsPassedOverForTheOneBefore) {
  const std::string sound = generations_->sound(newest());
  // Every second place among seal, HDF5's own structures, texts and small items, which lie in front.
  constexpr std::size_t front = 32768;
  const int count = places(120, 2200);
  for (int i = 0; i < count; ++i) {
    const std::size_t place = spread(i, i % 2 == 0 ? std::min(front, sound.size()) : sound.size());
    expect_passed_over(damaged(sound, place, i), fmt::format("place {}, kind {}", place, i % 5), newest(),
                       i % 100 == 99 ? 2 : 1);
    if (HasFatalFailure()) return;
  }
}

TEST_F(DamagedCheckpoint, SwappedForThatOfAnotherPointIsPassedOverAndKept) {
  SmallRun other(Changes{{"fluid.lambda", "4"}});
  other.set_steps(ThreeGenerations::steps[2]);
  other.finish();
  const std::string foreign = content_of(other.path(newest()));
  expect_passed_over(foreign, "another point's", "`fluid.lambda` was 4, the run has 5");
  EXPECT_EQ(content_of(run().path(newest() + ".foreign")), foreign);
}

TEST_F(DamagedCheckpoint, SwappedForThatOfAnotherStepIsPassedOver) {
  expect_passed_over(generations_->sound(generations_->checkpoint(0)), "another step's",
                     "its name does not belong to the step 20");
}

TEST_F(DamagedCheckpoint, SwappedForThatOfAnotherVersionIsPassedOver) {
  MemoryFile file(generations_->sound(newest()));
  std::string& bytes = file.content;
  const std::string entry = "\"layout\": 1";
  const std::size_t end_of_manifest = bytes.find('\n', bytes.find("\"metadata_checksum\"")) + 3;  // "\n}\n"
  const std::size_t manifest = bytes.rfind("{", bytes.find("\"lattice\":"));
  const auto checksum = [&] { return hex(text_checksum(bytes.substr(manifest, end_of_manifest - manifest))); };
  const std::string before = checksum();
  for (std::size_t at = bytes.find(entry); at != std::string::npos; at = bytes.find(entry, at + 1))
    bytes[at + entry.size() - 1] = '2';
  ASSERT_NE(bytes.find(before), std::string::npos);
  bytes.replace(bytes.find(before), before.size(), checksum());
  reseal(file);
  expect_passed_over(bytes, "another version's", "layout version 2");
}

TEST_F(DamagedCheckpoint, AllOfThemAreARefusalThatTouchesNothing) {
  for (int i = 0; i < 3; ++i) {
    generations_->put_back();
    for (int generation = 0; generation < 3; ++generation) {
      const std::string name = generations_->checkpoint(generation);
      const std::string& sound = generations_->sound(name);
      set_content(run().path(name), damaged(sound, spread(7 * i + generation, sound.size()), 2 + i));
    }
    std::vector<std::string> before;
    for (int generation = 0; generation < 3; ++generation)
      before.push_back(content_of(run().path(generations_->checkpoint(generation))));
    const Finished finished = run().run(i == 2 ? 2 : 1);
    figures().damage_positions += 3;
    figures().wrong_resumes += finished.code == 65 ? 0 : 1;
    EXPECT_EQ(finished.code, 65) << finished.err;
    EXPECT_EQ(run().samples(), generations_->sound("samples.csv"));
    for (int generation = 0; generation < 3; ++generation) {
      const std::string name = generations_->checkpoint(generation);
      EXPECT_EQ(content_of(run().path(name)), before[static_cast<std::size_t>(generation)]);
      EXPECT_THAT(finished.err, HasSubstr(name.substr(name.find('/') + 1) + " is rejected: "));
    }
  }
}

// An intact one among them must not keep the others from being named.
TEST_F(DamagedCheckpoint, DamagedAndForeignOnesAreARefusalThatNamesThemAll) {
  SmallRun other(Changes{{"fluid.lambda", "4"}});
  other.set_steps(ThreeGenerations::steps[1]);
  other.finish();
  const std::string foreign = content_of(other.path(generations_->checkpoint(1)));
  for (const int ranks : {1, 2}) {
    generations_->put_back();
    set_content(run().path(generations_->checkpoint(0)), "torn");
    set_content(run().path(generations_->checkpoint(1)), foreign);
    set_content(run().path(newest()), generations_->sound(newest()).substr(0, 5000));
    const Finished finished = run().run(ranks);
    figures().damage_positions += 2;
    figures().wrong_resumes += finished.code == 65 ? 0 : 1;
    EXPECT_EQ(finished.code, 65) << finished.err;
    const nlohmann::json rejected = run().exit_record().at("rejected_checkpoints");
    ASSERT_EQ(rejected.size(), 3U) << rejected;
    EXPECT_THAT(rejected[1].at("why").get<std::string>(), HasSubstr("`fluid.lambda` was 4, the run has 5"));
    for (const auto& checkpoint : rejected)
      EXPECT_THAT(finished.err, HasSubstr(checkpoint.at("file").get<std::string>() + " is rejected: "));
    EXPECT_EQ(content_of(run().path(generations_->checkpoint(1))), foreign);
  }
}

}  // namespace
}  // namespace rouleau::testing
