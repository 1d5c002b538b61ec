// SPDX-License-Identifier: BSD-3-Clause
// The sample log: its exact format, its torn tails, and samples that are there exactly once.
#include "storage/sample_log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <xxhash.h>

#include <bit>
#include <cstdlib>
#include <limits>

#include "base/error.hpp"
#include "support/file_system_double.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::testing {
namespace {

using ::testing::HasSubstr;

const std::vector<std::string> columns{"step", "time_s", "cell", "d_um"};

SampleRow row(std::int64_t step, std::int64_t cell = 0) {
  return {step, static_cast<double>(step) * 1.39e-6, cell, 1.0 / static_cast<double>(3 + step)};
}

class Samples : public ::testing::Test {
 protected:
  TemporaryDirectory directory;
  FileSystemDouble files;
  std::filesystem::path path = directory.path() / "samples.csv";
  bool superseded = false;
  SampleLog log = make();

  SampleLog make() {
    return SampleLog(files, path, columns, 1, [this] {
      if (superseded) fail(Exit::superseded, "a newer attempt exists");
    });
  }
  void add(SampleLog& to, std::int64_t from, std::int64_t end) {
    for (std::int64_t step = from; step < end; ++step) to.append(std::vector<SampleRow>{row(step)});
  }
};

TEST_F(Samples, LineIsAsTheContractSays) {
  log.start();
  const std::vector<SampleRow> rows{{std::int64_t{100}, 0.1, std::int64_t{0}, -2.5e-7},
                                    {std::int64_t{100}, 0.1, std::int64_t{1}, 3.0}};
  log.append(rows);
  const std::string first = "100,0.1,0,-2.5e-07";
  const std::string second = "100,0.1,1,3";
  const auto line = [](const std::string& text) {
    return fmt::format("{},{:016x}\n", text, XXH64(text.data(), text.size(), 0));
  };
  EXPECT_EQ(content_of(path), "step,time_s,cell,d_um,check\n" + line(first) + line(second));
}

TEST_F(Samples, NumbersReadBackToTheSameDouble) {
  for (const double value : {1.0 / 3.0, 1e-300, 5e-324, -0.0, 1e22, 123456789.123456789}) {
    const std::string line = format_sample({std::int64_t{0}, value});
    EXPECT_EQ(std::bit_cast<std::uint64_t>(std::strtod(line.c_str() + 2, nullptr)), std::bit_cast<std::uint64_t>(value))
        << line;
  }
}

TEST_F(Samples, BatchIsOneWrite) {
  log.start();
  const int before = files.calls;
  log.append(std::vector<SampleRow>{row(1, 0), row(1, 1), row(2, 0)});
  EXPECT_EQ(files.calls, before + 1);
}

TEST_F(Samples, ScanEndsAtATornOrChangedLine) {
  log.start();
  add(log, 0, 5);
  const std::string whole = content_of(path);
  EXPECT_EQ(scan_samples(files, path).valid_bytes, whole.size());
  EXPECT_EQ(scan_samples(files, path).rows, 5);
  EXPECT_EQ(scan_samples(files, path).columns, columns);
  const std::size_t last = whole.rfind('\n', whole.size() - 2) + 1;
  for (std::size_t cut = last; cut < whole.size(); ++cut) {
    set_content(path, whole.substr(0, cut));
    EXPECT_EQ(scan_samples(files, path).valid_bytes, last) << cut;
    EXPECT_EQ(scan_samples(files, path).rows, 4);
  }
  for (std::size_t i = last; i + 1 < whole.size(); ++i) {
    std::string changed = whole;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    set_content(path, changed);
    EXPECT_LE(scan_samples(files, path).valid_bytes, last) << i;
  }
}

TEST_F(Samples, LineWithTooFewFieldsIsNotValid) {
  set_content(path, "step,cell,check\n" + format_sample({std::int64_t{1}}));
  EXPECT_EQ(scan_samples(files, path).rows, 0);
  EXPECT_THAT(scan_samples(files, path).why_ended, HasSubstr("line 2"));
}

TEST_F(Samples, CutBackAndContinuedLogHasTheSameBytes) {
  log.start();
  add(log, 0, 10);
  const SampleLogPosition counted = log.sync();
  add(log, 10, 20);
  const std::string undisturbed = content_of(path);

  // Killed while writing: samples after the checkpoint and half a line.
  set_content(path, undisturbed.substr(0, undisturbed.size() - 7));
  SampleLog again = make();
  ASSERT_FALSE(again.obstacle(counted).has_value());
  again.cut_back(counted);
  EXPECT_EQ(again.sync(), counted);
  add(again, 10, 20);
  EXPECT_EQ(content_of(path), undisturbed);
}

TEST_F(Samples, PositionIsThatOfTheBytesOnDisk) {
  log.start();
  add(log, 0, 3);
  const std::string content = content_of(path);
  const SampleLogPosition position = log.sync();
  EXPECT_EQ(position.bytes, content.size());
  EXPECT_EQ(position.hash, fmt::format("{:016x}", XXH64(content.data(), content.size(), 0)));
}

TEST_F(Samples, LogThatLostWhatACheckpointCountedIsAnObstacle) {
  log.start();
  add(log, 0, 3);
  const SampleLogPosition counted = log.sync();
  const std::string content = content_of(path);
  SampleLog again = make();
  set_content(path, content.substr(0, content.size() - 1));
  EXPECT_THAT(again.obstacle(counted).value(), HasSubstr("the checkpoint had counted"));
  std::string changed = content;
  changed[40] = static_cast<char>(changed[40] ^ 1);
  set_content(path, changed);
  EXPECT_THAT(again.obstacle(counted).value(), HasSubstr("are not those that the checkpoint had counted"));
  try {
    again.cut_back(counted);
    FAIL() << "was cut back";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::bad_input);
  }
  EXPECT_EQ(content_of(path), changed);  // nothing was cut
  std::filesystem::remove(path);
  EXPECT_THAT(again.obstacle(counted).value(), HasSubstr("missing"));
}

TEST_F(Samples, LogThatCannotBeReadIsNotTakenForAnother) {
  log.start();
  add(log, 0, 3);
  const SampleLogPosition counted = log.sync();
  files.failing_call = "pread";
  files.failing_errno = EIO;
  try {
    static_cast<void>(log.obstacle(counted));
    FAIL() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::io);
  }
}

TEST_F(Samples, OfAnyLengthOnlyWhatWasCountedIsRead) {
  log.start();
  add(log, 0, 3);
  const SampleLogPosition counted = log.sync();
  const std::string before = content_of(path);
  std::filesystem::resize_file(path, 64U << 20U);
  const std::uint64_t read = files.bytes_read;
  SampleLog again = make();
  EXPECT_TRUE(again.has_samples());
  EXPECT_FALSE(again.obstacle(counted).has_value());
  again.cut_back(counted);
  EXPECT_EQ(content_of(path), before);
  // Thrice what was counted, and two times as much as a line may have.
  EXPECT_LT(files.bytes_read - read, 3 * counted.bytes + (4U << 16U));
}

TEST_F(Samples, HeaderAloneIsNoSample) {
  EXPECT_FALSE(log.has_samples()) << "no file";
  log.start();
  EXPECT_FALSE(log.has_samples());
  add(log, 0, 1);
  EXPECT_TRUE(log.has_samples());
  set_content(path, "");
  EXPECT_FALSE(log.has_samples());
  set_content(path, "no line");
  EXPECT_TRUE(log.has_samples()) << "nobody knows what it is";
}

TEST_F(Samples, OtherColumnsAreAnObstacle) {
  log.start();
  add(log, 0, 3);
  const SampleLogPosition counted = log.sync();
  const SampleLog other(files, path, {"step", "cell"}, 1, [] {});
  EXPECT_THAT(other.obstacle(counted).value(), HasSubstr("other columns"));
}

TEST_F(Samples, LogOfAnOlderVersionGoesOnWithTheColumnsItHas) {
  log.start();
  add(log, 0, 3);
  const SampleLogPosition counted = log.sync();
  add(log, 3, 6);
  const std::string undisturbed = content_of(path);

  SampleLog newer(files, path, {"step", "new", "time_s", "cell", "d_um", "newer"}, 1, [] {});
  ASSERT_FALSE(newer.obstacle(counted).has_value());
  newer.cut_back(counted);
  for (std::int64_t step = 3; step < 6; ++step) {
    const SampleRow old = row(step);
    newer.append(std::vector<SampleRow>{{old[0], 0.5, old[1], old[2], old[3], 0.25}});
  }
  EXPECT_EQ(content_of(path), undisturbed);
  EXPECT_THROW(newer.append(std::vector<SampleRow>{{std::int64_t{5}, 0.5, 0.0, std::int64_t{0}, 0.0, 0.25}}),
               std::logic_error);  // the last step was read from the file
}

TEST_F(Samples, StartReplacesALogWithoutACheckpoint) {
  log.start();
  add(log, 0, 3);
  const std::string undisturbed = content_of(path);
  SampleLog again = make();
  again.start();
  add(again, 0, 3);
  EXPECT_EQ(content_of(path), undisturbed);
}

TEST_F(Samples, SupersededSolverAppendsNothing) {
  log.start();
  add(log, 0, 3);
  const SampleLogPosition counted = log.sync();
  const std::string before = content_of(path);
  superseded = true;
  EXPECT_THROW(log.append(std::vector<SampleRow>{row(3)}), Error);
  EXPECT_THROW(log.cut_back(counted), Error);
  EXPECT_THROW(log.start(), Error);
  EXPECT_EQ(content_of(path), before);
}

TEST_F(Samples, OlderAttemptThatStillHasTheLogOpenCannotReachIt) {
  log.start();
  add(log, 0, 3);
  const SampleLogPosition counted = log.sync();
  const std::string before = content_of(path);
  SampleLog newer(files, path, columns, 2, [] {});
  newer.cut_back(counted);
  add(log, 3, 4);  // its fence was asked before there was a newer attempt
  EXPECT_EQ(content_of(path), before);
}

TEST_F(Samples, AnotherWriterIsNoticed) {
  log.start();
  add(log, 0, 3);
  set_content(path, content_of(path) + "x");
  try {
    log.append(std::vector<SampleRow>{row(3)});
    FAIL() << "was written";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::io);
    EXPECT_THAT(error.what(), HasSubstr("another program writes"));
  }
}

TEST_F(Samples, ValueThatIsNotFiniteIsRefusedByName) {
  log.start();
  const std::string before = content_of(path);
  SampleRow bad = row(7);
  bad[3] = std::numeric_limits<double>::quiet_NaN();
  try {
    log.append(std::vector<SampleRow>{row(6), bad});
    FAIL() << "was written";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::physics);
    EXPECT_THAT(error.what(), HasSubstr("step 7: sample `d_um` of cell 0 is not finite"));
  }
  EXPECT_EQ(content_of(path), before);
}

TEST_F(Samples, StepAndCellMustIncreaseAlsoAcrossAResume) {
  log.start();
  log.append(std::vector<SampleRow>{row(5, 0), row(5, 1)});
  EXPECT_THROW(log.append(std::vector<SampleRow>{row(5, 1)}), std::logic_error);
  EXPECT_THROW(log.append(std::vector<SampleRow>{row(4, 7)}), std::logic_error);
  const SampleLogPosition counted = log.sync();
  SampleLog again = make();
  again.cut_back(counted);
  EXPECT_THROW(again.append(std::vector<SampleRow>{row(5, 1)}), std::logic_error);
  again.append(std::vector<SampleRow>{row(5, 2)});
}

TEST_F(Samples, FullDiskIsAnIoError) {
  log.start();
  files.failing_call = "write";
  files.failing_errno = ENOSPC;
  try {
    add(log, 0, 1);
    FAIL() << "was written";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::io);
    EXPECT_THAT(error.what(), HasSubstr("No space left"));
    EXPECT_THAT(error.what(), HasSubstr("are needed"));
  }
}

// A checkpoint must not count samples that may be lost with the power.
TEST_F(Samples, SyncThatFailsIsAnIoErrorThatNamesTheFile) {
  log.start();
  add(log, 0, 3);
  files.failing_call = "fsync";
  files.failing_errno = EIO;
  try {
    static_cast<void>(log.sync());
    FAIL() << "was taken for synced";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::io);
    EXPECT_THAT(error.what(), HasSubstr(path.string() + ": fsync failed"));
  }
}

}  // namespace
}  // namespace rouleau::testing
