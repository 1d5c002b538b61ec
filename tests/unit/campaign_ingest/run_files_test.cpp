// SPDX-License-Identifier: BSD-3-Clause
// Records of a run directory: whole, missing, damaged.
#include "ingest/run_files.hpp"

#include <gmock/gmock.h>

#include "written_campaign.hpp"

namespace rouleau::campaign {
namespace {

using ::rouleau::testing::set_content;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class RunFilesTest : public ::testing::Test {
 protected:
  RunFilesTest() { campaign_.add_attempt(key_, 1, 800); }

  testing::WrittenCampaign campaign_;
  std::string key_ = campaign_.add_point(1).key;
  std::filesystem::path attempt_ = campaign_.run(key_) / "attempts" / "1";
  std::vector<std::string> warnings_;
};

TEST_F(RunFilesTest, RecordsAreRead) {
  campaign_.end_attempt(key_, 1, 75, 800, 1200);
  const std::optional<ExitFile> exit = read_exit_file(attempt_ / "exit.json", warnings_);
  ASSERT_TRUE(exit);
  EXPECT_EQ(exit->code, 75);
  EXPECT_EQ(exit->start_step, 800);
  EXPECT_EQ(exit->step, 1200);
  EXPECT_EQ(exit->core_s, 21.0);
  const std::optional<ProcessFile> process = read_process_file(attempt_ / "process.json", warnings_);
  ASSERT_TRUE(process);
  EXPECT_EQ(process->pid, 4711);
  EXPECT_EQ(process->checkpoint_step, 800);
  EXPECT_EQ(read_first_line(attempt_ / "owner"), "token1");
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(RunFilesTest, ProgressIsReadWithNullsAsUnset) {
  set_content(attempt_ / "progress.json", R"({"contract": 1, "attempt": 3, "step": 12, "end_step": 144, "time_s": 0.1,
    "end_time_s": 0.2, "steps_per_s": 512.0, "d_um": null})");
  const std::optional<ProgressFile> progress = read_progress_file(attempt_ / "progress.json", warnings_);
  ASSERT_TRUE(progress);
  EXPECT_EQ(progress->end_step, 144);
  EXPECT_EQ(progress->steps_per_s, 512.0);
  EXPECT_EQ(progress->d_um, std::nullopt);
}

TEST_F(RunFilesTest, TimeOfACheckpointThatIsNotThereIsUnset) {
  set_content(attempt_ / "progress.json",
              R"({"attempt": 1, "step": 5, "end_step": 9, "checkpoint_step": 0, "checkpoint_unix_s": 0.0})");
  const std::optional<ProgressFile> progress = read_progress_file(attempt_ / "progress.json", warnings_);
  ASSERT_TRUE(progress);
  EXPECT_FALSE(progress->checkpoint_unix_s) << "read as a checkpoint of 1970";
}

TEST_F(RunFilesTest, MissingFileIsNothingAndNoWarning) {
  EXPECT_EQ(read_exit_file(attempt_ / "exit.json", warnings_).has_value(), false);
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(RunFilesTest, DamagedFileIsNothingAndAWarningThatNamesIt) {
  for (const char* text : {"", "{", "[]", R"({"code": "zero"})", R"({"reason": "no code"})", "\xff\xfe"}) {
    warnings_.clear();
    set_content(attempt_ / "exit.json", text);
    EXPECT_FALSE(read_exit_file(attempt_ / "exit.json", warnings_)) << text;
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("attempts/1/exit.json: is damaged"))) << text;
  }
}

TEST_F(RunFilesTest, NumbersOfAttemptsAndCheckpointsComeFromNames) {
  campaign_.add_attempt(key_, 10);
  campaign_.add_attempt(key_, 2);
  std::filesystem::create_directories(campaign_.run(key_) / "attempts" / "notes");
  campaign_.add_checkpoint(key_, 2000);
  campaign_.add_checkpoint(key_, 1000);
  set_content(campaign_.run(key_) / "checkpoints" / "000000003000.h5.tmp", "rubbish");
  EXPECT_THAT(attempt_numbers(campaign_.run(key_)), ElementsAre(1, 2, 10));
  EXPECT_THAT(checkpoint_steps(campaign_.run(key_)), ElementsAre(1000, 2000));
  EXPECT_THAT(attempt_numbers(campaign_.path() / "nowhere"), IsEmpty());
}

}  // namespace
}  // namespace rouleau::campaign
