// SPDX-License-Identifier: BSD-3-Clause
// A disk that fills up, at every depth at which that can be noticed, ends as one clear error on all ranks.
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include <csignal>
#include <limits>

#include "base/error.hpp"
#include "storage/checkpoint.hpp"
#include "storage/inspect.hpp"
#include "storage/resume.hpp"
#include "support/file_system_double.hpp"
#include "support/shared_directory.hpp"
#include "support/small_state.hpp"

namespace rouleau::testing {
namespace {

const Int3 size{48, 32, 16};  // 5 components of doubles: 983 KB a checkpoint

class DiskFull : public ::testing::Test {
 protected:
  Communicator comm;
  SharedDirectory directory{comm};
  FileSystemDouble files;
  CheckpointPlace place{files, directory.path() / "checkpoints", [] {}, 3};

  Error failure_of_save(std::int64_t step) {
    try {
      SmallState<double> state(size, block_of(size, 1, comm.rank(), comm.size()));
      state.fill(static_cast<std::uint64_t>(step));
      save_checkpoint(place, comm, state.list(), small_metadata(step));
    } catch (const Error& error) {
      return error;
    }
    return {Exit::finished, ""};
  }

  /// The first generation is sound, nothing else is left.
  void expect_only_the_first() {
    comm.barrier();
    const auto names = list_directory(posix_file_system(), place.directory);
    EXPECT_EQ(names, std::vector<std::string>{checkpoint_name(1)});
    EXPECT_TRUE(verify_checkpoint(posix_file_system(), place.directory / checkpoint_name(1)).sound);
    comm.barrier();
  }
};

class SmallDisk : public DiskFull {
 protected:
  void SetUp() override {
    int mounted = 1;
    if (comm.is_root()) {
      mounted = ::mount("tmpfs", directory.path().c_str(), "tmpfs", 0, "size=1536k") == 0 ? 1 : 0;
    }
    comm.broadcast(&mounted, sizeof mounted);
    if (mounted == 0) GTEST_SKIP() << "mounting a small tmpfs needs root";
    mounted_ = true;
    ASSERT_EQ(failure_of_save(1).code(), Exit::finished);
  }
  void TearDown() override {
    comm.barrier();
    if (mounted_ && comm.is_root()) {
      EXPECT_EQ(::umount2(directory.path().c_str(), MNT_DETACH), 0);
    }
  }
  bool mounted_ = false;
};

TEST_F(SmallDisk, IsNoticedBeforeAnythingIsWritten) {
  const Error error = failure_of_save(2);
  EXPECT_EQ(error.code(), Exit::io);
  EXPECT_NE(std::string(error.what()).find("a checkpoint needs 10"), std::string::npos) << error.what();
  expect_only_the_first();
}

TEST_F(SmallDisk, IsNoticedWhenBlocksAreReserved) {
  files.claimed_space = std::numeric_limits<std::uint64_t>::max();
  const Error error = failure_of_save(2);
  EXPECT_EQ(error.code(), Exit::io);
  EXPECT_NE(std::string(error.what()).find("No space left on device"), std::string::npos) << error.what();
  EXPECT_NE(std::string(error.what()).find("bytes are needed"), std::string::npos) << error.what();
  expect_only_the_first();
}

// A file system that promises blocks and has none: the writing of the values itself fails.
TEST_F(SmallDisk, IsNoticedWhenValuesAreWritten) {
  files.claimed_space = std::numeric_limits<std::uint64_t>::max();
  files.skip_allocation = true;
  const Error error = failure_of_save(2);
  EXPECT_EQ(error.code(), Exit::io);
  EXPECT_NE(std::string(error.what()).find("No space left on device"), std::string::npos) << error.what();
  expect_only_the_first();
}

TEST_F(SmallDisk, RunGoesOnWhenThereIsRoomAgain) {
  EXPECT_EQ(failure_of_save(2).code(), Exit::io);
  comm.barrier();
  if (comm.is_root()) remove_file(files, place.directory / checkpoint_name(1));
  comm.barrier();
  EXPECT_EQ(failure_of_save(2).code(), Exit::finished);
}

/// Limits the size of files that this rank can write.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

// Whichever rank's writes fail, all of them get the error, and none waits for ever.
TEST_F(DiskFull, FailureOfOneRankIsEverybodys) {
  ASSERT_EQ(failure_of_save(1).code(), Exit::finished);
  files.skip_allocation = true;
  for (int limited = 0; limited < comm.size(); ++limited) {
    Error error(Exit::finished, "");
    {
      const FileSizeLimit limit(comm.rank() == limited ? 400000 : RLIM_INFINITY);
      error = failure_of_save(2);
    }
    // 400000 bytes end inside the second of five components, so every rank has planes beyond them.
    EXPECT_EQ(error.code(), Exit::io) << "limited rank " << limited;
    EXPECT_NE(std::string(error.what()).find("ulimit -f"), std::string::npos) << error.what();
    expect_only_the_first();
  }
}

}  // namespace
}  // namespace rouleau::testing
