// SPDX-License-Identifier: BSD-3-Clause
// Checkpoints keep every bit, for any decomposition, and are whole or not there.
#include "storage/checkpoint.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "storage/generations.hpp"
#include "storage/inspect.hpp"
#include "storage/resume.hpp"
#include "storage/unfinished.hpp"
#include "support/file_system_double.hpp"
#include "support/shared_directory.hpp"
#include "support/small_state.hpp"

namespace rouleau::testing {
namespace {

const Int3 size{13, 9, 8};

template <class Real>
SmallState<Real> own_part(const Communicator& comm, int way, std::uint64_t step) {
  SmallState<Real> state(size, block_of(size, way, comm.rank(), comm.size()));
  state.fill(step);
  return state;
}

Expected expectation() {
  const CheckpointMetadata metadata = small_metadata(0);
  return {metadata.parameters, metadata.identity, {}};
}

int files_in(const std::filesystem::path& directory) {
  return static_cast<int>(list_directory(posix_file_system(), directory).size());
}

class Checkpoint : public ::testing::Test {
 protected:
  Communicator comm;
  SharedDirectory directory{comm};
  FileSystemDouble files;
  CheckpointPlace place{files, directory.path() / "checkpoints", [] {}, 3};

  template <class Real>
  SavedCheckpoint save(std::int64_t step, int way = 0) {
    SmallState<Real> state = own_part<Real>(comm, way, static_cast<std::uint64_t>(step));
    return save_checkpoint(place, comm, state.list(), small_metadata(step));
  }

  /// Saves and returns the exit code and message that all ranks got; finished if none did.
  template <class Real>
  Error failure_of_save(std::int64_t step) {
    try {
      save<Real>(step);
    } catch (const Error& error) {
      return error;
    }
    return {Exit::finished, ""};
  }
};

template <class Real>
void round_trips(const Communicator& comm, const CheckpointPlace& place) {
  for (int written = 0; written < 3; ++written) {
    SmallState<Real> state = own_part<Real>(comm, written, 7);
    save_checkpoint(place, comm, state.list(), small_metadata(7));
    for (int ranks = 1; ranks <= comm.size(); ++ranks) {
      MPI_Comm part = MPI_COMM_NULL;
      MPI_Comm_split(comm.raw(), comm.rank() < ranks ? 0 : MPI_UNDEFINED, comm.rank(), &part);
      if (part != MPI_COMM_NULL) {
        const Communicator fewer(part);
        for (int read = 0; read < 3; ++read) {
          const SmallState<Real> wanted = own_part<Real>(fewer, read, 7);
          SmallState<Real> loaded = own_part<Real>(fewer, read, 1234);
          PersistentState list = loaded.list();
          const Resumed resumed = load_newest(place.files, place.directory, fewer, expectation(), list);
          ASSERT_TRUE(resumed.metadata.has_value());
          EXPECT_EQ(*resumed.metadata, small_metadata(7));
          EXPECT_TRUE(resumed.rejected.empty());
          EXPECT_TRUE(loaded.same_bits(wanted))
              << "written way " << written << ", read way " << read << " on " << ranks;
        }
        MPI_Comm_free(&part);
      }
      comm.barrier();
    }
  }
}

TEST_F(Checkpoint, RoundTripKeepsEveryBitInDoubleOnAnyDecomposition) { round_trips<double>(comm, place); }
TEST_F(Checkpoint, RoundTripKeepsEveryBitInSingleOnAnyDecomposition) { round_trips<float>(comm, place); }

TEST_F(Checkpoint, SameStateGivesTheSameFileBytesOnAnyDecomposition) {
  save<float>(5, 0);
  const std::string first = content_of(place.directory / checkpoint_name(5));
  comm.barrier();
  for (int way = 1; way < 3; ++way) {
    save<float>(5, way);
    EXPECT_TRUE(content_of(place.directory / checkpoint_name(5)) == first) << "way " << way;
    comm.barrier();
  }
}

TEST_F(Checkpoint, DigestIsTheFilesAndIgnoresTheDecomposition) {
  SmallState<double> state = own_part<double>(comm, 0, 5);
  const std::string known = digest(state.list(), comm);
  for (int way = 0; way < 3; ++way) {
    SmallState<double> other = own_part<double>(comm, way, 5);
    EXPECT_EQ(digest(other.list(), comm), known);
  }
  const SavedCheckpoint saved = save<double>(5, 2);
  EXPECT_EQ(inspect_checkpoint(files, saved.file).digest, known);
}

TEST_F(Checkpoint, DigestChangesWithAnyOneValue) {
  SmallState<float> state = own_part<float>(comm, 0, 5);
  const std::string known = digest(state.list(), comm);
  std::uint8_t& flag = state.flags(0, 0, 0);
  if (comm.is_root()) flag ^= 1U;
  EXPECT_NE(digest(state.list(), comm), known);
  if (comm.is_root()) flag ^= 1U;
  EXPECT_EQ(digest(state.list(), comm), known);
  state.controller[1] = std::nextafter(state.controller[1], 2.0);
  EXPECT_NE(digest(state.list(), comm), known);
}

TEST_F(Checkpoint, ValueThatIsNotFiniteIsRefusedByPlace) {
  save<float>(1);
  SmallState<float> state = own_part<float>(comm, 0, 2);
  const bool mine = comm.rank() == comm.size() - 1;
  if (mine) state.f[3](0, 4, 2) = std::numeric_limits<float>::quiet_NaN();
  const int x = block_of(size, 0, comm.size() - 1, comm.size()).begin[0];
  try {
    save_checkpoint(place, comm, state.list(), small_metadata(2));
    FAIL() << "was written";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::physics);
    const std::string place_named =
        fmt::format("step 2: fluid/f component 3 is not finite (nan) at node ({}, 4, 2)", x);
    EXPECT_NE(std::string(error.what()).find(place_named), std::string::npos) << error.what();
  }
  EXPECT_EQ(files_in(place.directory), 1);
}

TEST_F(Checkpoint, ReplicatedValueThatIsNotFiniteIsRefused) {
  SmallState<double> state = own_part<double>(comm, 0, 2);
  state.X[4] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(save_checkpoint(place, comm, state.list(), small_metadata(2)), Error);
}

TEST_F(Checkpoint, RanksThatDisagreeAboutAReplicatedItemAreNotWritten) {
  if (comm.size() == 1) GTEST_SKIP() << "needs two ranks";
  SmallState<double> state = own_part<double>(comm, 0, 2);
  if (comm.rank() == 1) state.X[4] = std::nextafter(state.X[4], 2.0);
  try {
    save_checkpoint(place, comm, state.list(), small_metadata(2));
    FAIL() << "was written";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::physics);
    EXPECT_NE(std::string(error.what()).find("cells/X on rank 1"), std::string::npos) << error.what();
  }
}

TEST_F(Checkpoint, NewestGenerationsAreKept) {
  for (const std::int64_t step : {10, 20, 30, 40, 50}) save<float>(step);
  comm.barrier();
  EXPECT_EQ(list_directory(files, place.directory),
            (std::vector<std::string>{checkpoint_name(30), checkpoint_name(40), checkpoint_name(50)}));
}

TEST_F(Checkpoint, LaterGenerationsThatAResumeRejectedDoNotCountAsKept) {
  for (const std::int64_t step : {10, 20, 30}) save<float>(step);
  save<float>(25);
  comm.barrier();
  EXPECT_EQ(list_directory(files, place.directory),
            (std::vector<std::string>{checkpoint_name(10), checkpoint_name(20), checkpoint_name(25)}));
}

TEST_F(Checkpoint, SupersededSolverLeavesTheDirectoryAsItWas) {
  save<float>(10);
  // The newer attempt may appear before the file is begun or while it is written.
  for (const int allowed : {0, 1}) {
    int asked = 0;
    place.fence = [&] {
      if (asked++ >= allowed) fail(Exit::superseded, "attempt 2 has taken over");
    };
    EXPECT_EQ(failure_of_save<float>(20).code(), Exit::superseded);
    comm.barrier();
    EXPECT_EQ(list_directory(files, place.directory), std::vector<std::string>{checkpoint_name(10)});
    comm.barrier();
  }
}

TEST_F(Checkpoint, LeftoversOfCrashedWritersAreRemovedButNotThoseOfASuccessor) {
  save<float>(10);
  if (comm.is_root()) {
    set_content(place.directory / unfinished_name(checkpoint_name(15), 1), "torn");
    set_content(place.directory / unfinished_name(checkpoint_name(15), 2), "being written by attempt 2");
  }
  save<float>(20);
  comm.barrier();
  EXPECT_EQ(
      list_directory(files, place.directory),
      (std::vector<std::string>{checkpoint_name(10), unfinished_name(checkpoint_name(15), 2), checkpoint_name(20)}));
}

TEST_F(Checkpoint, EstimateIsAnUpperBoundAndNotFarOff) {
  SmallState<double> state = own_part<double>(comm, 0, 3);
  const std::uint64_t estimate = estimate_bytes(state.list());
  const std::uint64_t bytes = save<double>(3).bytes;
  const std::uint64_t texts = 8192;  // metadata and manifest of this state
  EXPECT_LE(bytes, estimate + texts);
  EXPECT_GE(bytes + 65536, estimate);
}

TEST_F(Checkpoint, FileIsPlainHdf5BehindItsSeal) {
  save<float>(3);
  const std::string content = content_of(place.directory / checkpoint_name(3));
  EXPECT_TRUE(content.starts_with("rouleau checkpoint\nbytes "));
  EXPECT_EQ(content.substr(512, 8), "\x89HDF\r\n\x1a\n");
}

TEST_F(Checkpoint, EveryFailingCallEndsAsOneErrorOnAllRanksAndKeepsTheOldGeneration) {
  save<float>(10);
  for (const char* call : {"pwrite", "pread", "allocate", "fsync", "close", "rename"}) {
    files.failing_call = comm.is_root() ? call : "";
    files.failing_errno = EACCES;
    const Error error = failure_of_save<float>(20);
    files.failing_call.clear();
    EXPECT_EQ(error.code(), Exit::io) << call;
    comm.barrier();
    const auto newest = find_checkpoints(posix_file_system(), place.directory).front();
    EXPECT_TRUE(verify_checkpoint(posix_file_system(), newest).sound) << call;
    EXPECT_TRUE(exists(posix_file_system(), place.directory / checkpoint_name(10))) << call;
    comm.barrier();
  }
}

}  // namespace
}  // namespace rouleau::testing
