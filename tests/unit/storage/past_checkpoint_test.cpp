// SPDX-License-Identifier: BSD-3-Clause
// A run's own records tell of a checkpoint that is gone.
#include "storage/past_checkpoint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "storage/records.hpp"
#include "support/file_system_double.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::testing {
namespace {

using ::testing::HasSubstr;

class PastCheckpoint : public ::testing::Test {
 protected:
  TemporaryDirectory directory;
  FileSystemDouble files;
  Attempt attempt = Attempt::claim(files, directory.path());
  std::filesystem::path progress = directory.path() / "progress.json";

  void end(Exit code, const std::string& resumed_from = "") {
    ExitRecord record;
    record.code = code;
    record.step = 12;
    record.resumed_from = resumed_from;
    write_exit_record(files, attempt.directory(), record);
  }
  void report(std::int64_t checkpoint_step) {
    Progress p;
    p.checkpoint_step = checkpoint_step;
    write_progress(files, attempt, p);
  }
  std::string told() { return past_checkpoint(files, directory.path()).value_or("nothing"); }
};

TEST_F(PastCheckpoint, NothingIsToldByARunThatHadNone) {
  EXPECT_EQ(told(), "nothing");
  report(0);
  end(Exit::io);
  EXPECT_EQ(told(), "nothing");
}

TEST_F(PastCheckpoint, IsToldByProgress) {
  report(12);
  EXPECT_THAT(told(), HasSubstr("progress.json tells of one of step 12"));
}

TEST_F(PastCheckpoint, IsToldByTheEndOfAnyAttempt) {
  for (const Exit code : {Exit::finished, Exit::stopped}) {
    end(code);
    EXPECT_THAT(told(), HasSubstr("attempts/1/exit.json tells of one of step 12"));
  }
  end(Exit::io, "checkpoints/000000000008.h5");
  static_cast<void>(Attempt::claim(files, directory.path()));
  EXPECT_THAT(told(), HasSubstr("attempts/1/exit.json tells of checkpoints/000000000008.h5"));
}

TEST_F(PastCheckpoint, DamagedRecordRulesNothingOut) {
  report(0);
  std::string text = content_of(progress);
  text[text.find("\"step\": 0") + 8] = '7';
  for (const std::string& damaged : {text, std::string("{"), std::string("[1]"), std::string(2U << 20U, ' ')}) {
    set_content(progress, damaged);
    EXPECT_THAT(told(), HasSubstr("progress.json is damaged"));
  }
}

}  // namespace
}  // namespace rouleau::testing
