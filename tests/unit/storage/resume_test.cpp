// SPDX-License-Identifier: BSD-3-Clause
// A run goes on from the newest checkpoint that is whole and its own, and says what it passed over.
#include "storage/resume.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "storage/checkpoint.hpp"
#include "storage/checksum.hpp"
#include "storage/seal.hpp"
#include "support/file_system_double.hpp"
#include "support/shared_directory.hpp"
#include "support/small_state.hpp"

namespace rouleau::testing {
namespace {

using ::testing::HasSubstr;
const Int3 size{7, 6, 8};

class Resume : public ::testing::Test {
 protected:
  Communicator comm;
  SharedDirectory directory{comm};
  FileSystemDouble files;
  CheckpointPlace place{files, directory.path() / "checkpoints", [] {}, 3};
  CheckpointMetadata metadata = small_metadata(0);
  Expected expected{metadata.parameters, metadata.identity, {}};
  SmallState<float> loaded{size, block_of(size, 1, comm.rank(), comm.size())};

  void save(std::int64_t step, const Int3& n = size) {
    SmallState<float> state(n, block_of(n, 0, comm.rank(), comm.size()));
    state.fill(static_cast<std::uint64_t>(step));
    metadata.step = step;
    save_checkpoint(place, comm, state.list(), metadata);
  }
  Resumed load() {
    loaded.fill(999);
    PersistentState list = loaded.list();
    return load_newest(files, place.directory, comm, expected, list);
  }
  Error refusal() {
    try {
      load();
    } catch (const Error& error) {
      return error;
    }
    return {Exit::finished, ""};
  }
  bool holds(std::uint64_t step) {
    SmallState<float> wanted(size, loaded.block);
    wanted.fill(step);
    return loaded.same_bits(wanted);
  }
  /// Changes a generation's bytes on rank 0.
  template <class Change>
  void damage(std::int64_t step, const Change& change) {
    comm.barrier();
    if (comm.is_root()) {
      std::string content = content_of(place.directory / checkpoint_name(step));
      change(content);
      set_content(place.directory / checkpoint_name(step), content);
    }
    comm.barrier();
  }
};

TEST_F(Resume, EmptyDirectoryMeansStepZero) {
  const Resumed resumed = load();
  EXPECT_FALSE(resumed.metadata.has_value());
  EXPECT_TRUE(resumed.rejected.empty());
}

TEST_F(Resume, NewestIsTaken) {
  for (const std::int64_t step : {10, 20, 30}) save(step);
  const Resumed resumed = load();
  ASSERT_TRUE(resumed.metadata.has_value());
  EXPECT_EQ(resumed.metadata->step, 30);
  EXPECT_EQ(resumed.file, place.directory / checkpoint_name(30));
  EXPECT_TRUE(holds(30));
}

TEST_F(Resume, DamagedGenerationsArePassedOverAndNamed) {
  for (const std::int64_t step : {10, 20, 30}) save(step);
  damage(30, [](std::string& content) { content[content.size() / 2] ^= 1; });
  damage(20, [](std::string& content) { content.resize(content.size() - 100); });
  const Resumed resumed = load();
  ASSERT_TRUE(resumed.metadata.has_value());
  EXPECT_EQ(resumed.metadata->step, 10);
  EXPECT_TRUE(holds(10));
  ASSERT_EQ(resumed.rejected.size(), 2U);
  EXPECT_EQ(resumed.rejected[0].file, checkpoint_name(30));
  EXPECT_THAT(resumed.rejected[0].why, HasSubstr("damaged"));
  EXPECT_EQ(resumed.rejected[1].file, checkpoint_name(20));
}

TEST_F(Resume, ZeroedPageIsNoticed) {
  save(10);
  save(20);
  damage(20, [](std::string& content) { content.replace(content.size() - 4096, 4096, 4096, '\0'); });
  EXPECT_EQ(load().metadata->step, 10);
}

TEST_F(Resume, LongerFileIsNoticed) {
  save(10);
  save(20);
  damage(20, [](std::string& content) { content += "x"; });
  EXPECT_EQ(load().metadata->step, 10);
}

TEST_F(Resume, EmptyAndForeignFilesAreNoticed) {
  save(10);
  save(20);
  save(30);
  damage(30, [](std::string& content) { content.clear(); });
  damage(20, [](std::string& content) { content = "this is a text file\n"; });
  const Resumed resumed = load();
  EXPECT_EQ(resumed.metadata->step, 10);
  EXPECT_THAT(resumed.rejected[1].why, HasSubstr("not a checkpoint"));
}

TEST_F(Resume, SwappedFilesAreNoticed) {
  for (const std::int64_t step : {10, 20, 30}) save(step);
  comm.barrier();
  if (comm.is_root()) {
    std::filesystem::rename(place.directory / checkpoint_name(20), place.directory / "x");
    std::filesystem::rename(place.directory / checkpoint_name(30), place.directory / checkpoint_name(20));
    std::filesystem::rename(place.directory / "x", place.directory / checkpoint_name(30));
  }
  comm.barrier();
  const Resumed resumed = load();
  EXPECT_EQ(resumed.metadata->step, 10);
  EXPECT_TRUE(holds(10));
  EXPECT_THAT(resumed.rejected[0].why, HasSubstr("name does not belong to the step 20"));
}

TEST_F(Resume, UnfinishedFilesAreNotLookedAt) {
  save(10);
  comm.barrier();
  if (comm.is_root()) {
    std::filesystem::copy_file(place.directory / checkpoint_name(10), place.directory / "000000000020.h5.a1.tmp");
    std::filesystem::copy_file(place.directory / checkpoint_name(10), place.directory / "20.h5");
  }
  comm.barrier();
  const Resumed resumed = load();
  EXPECT_EQ(resumed.metadata->step, 10);
  EXPECT_TRUE(resumed.rejected.empty());
}

TEST_F(Resume, AllDamagedMeansStepZeroWithReasons) {
  save(10);
  damage(10, [](std::string& content) { content[600] ^= 4; });
  const Resumed resumed = load();
  EXPECT_FALSE(resumed.metadata.has_value());
  EXPECT_EQ(resumed.rejected.size(), 1U);
}

TEST_F(Resume, ChangedIdentityParameterIsRefusedByNameWithBothValues) {
  save(10);
  expected.parameters["fluid.lambda"].value = "5";
  const Error error = refusal();
  EXPECT_EQ(error.code(), Exit::bad_input);
  EXPECT_THAT(error.what(), HasSubstr("`fluid.lambda` was 4.75, the run has 5"));
}

TEST_F(Resume, ChangedFreeParameterIsNoObstacle) {
  save(10);
  expected.parameters["time.end_time_s"].value = "9.26";
  EXPECT_EQ(load().metadata->step, 10);
}

TEST_F(Resume, BranchMayChangeWhatItDeclaresFree) {
  save(10);
  expected.parameters["fluid.lambda"] = {"6", "5", false};
  expected.identity.clear();
  EXPECT_EQ(load().metadata->step, 10);
}

TEST_F(Resume, ParameterThatOneSideDoesNotKnowCountsAsItsDefault) {
  metadata.parameters["old.option"] = {"1", "1", true};
  save(10);
  expected.parameters["new.option"] = {"off", "off", true};
  EXPECT_EQ(load().metadata->step, 10);
  expected.parameters["new.option"].value = "on";
  EXPECT_THAT(refusal().what(), HasSubstr("`new.option` was off, the run has on"));
  expected.parameters.erase("new.option");
  metadata.parameters["old.option"].value = "2";
  save(20);
  const Resumed resumed = load();
  EXPECT_EQ(resumed.metadata->step, 10) << "one foreign file among our own";
  ASSERT_EQ(resumed.rejected.size(), 1U);
  EXPECT_TRUE(resumed.rejected[0].foreign);
  EXPECT_THAT(resumed.rejected[0].why, HasSubstr("`old.option` was 2, the run has no such parameter"));
}

TEST_F(Resume, ChangedContentOfAFileInTheRunFileIsRefused) {
  save(10);
  expected.identity = "ffffffffffffffffffffffffffffffff";
  const Error error = refusal();
  EXPECT_EQ(error.code(), Exit::bad_input);
  EXPECT_THAT(error.what(), HasSubstr("a file named in the run file has changed"));
}

TEST_F(Resume, ObstacleFallsBackAGeneration) {
  for (const std::int64_t step : {10, 20, 30}) save(step);
  expected.obstacle = [](const CheckpointMetadata& m) -> std::optional<std::string> {
    if (m.step > 15) return "samples.csv is shorter";
    return {};
  };
  const Resumed resumed = load();
  EXPECT_EQ(resumed.metadata->step, 10);
  EXPECT_EQ(resumed.rejected.size(), 2U);
  EXPECT_EQ(resumed.rejected[0].why, "samples.csv is shorter");
}

TEST_F(Resume, IntactCheckpointsThatCannotBeContinuedAreNotIgnored) {
  save(10);
  expected.obstacle = [](const CheckpointMetadata&) { return std::optional<std::string>("samples.csv is missing"); };
  const Error error = refusal();
  EXPECT_EQ(error.code(), Exit::bad_input);
  EXPECT_THAT(error.what(), HasSubstr("samples.csv is missing"));
}

// The message names the newest intact one; which others there were, and why, would not be known.
TEST_F(Resume, RefusalCarriesAllThatWereRejected) {
  for (const std::int64_t step : {10, 20, 30}) save(step);
  damage(30, [](std::string& content) { content.resize(content.size() - 100); });
  expected.obstacle = [](const CheckpointMetadata& m) {
    return std::optional<std::string>(fmt::format("no samples of step {}", m.step));
  };
  try {
    load();
    FAIL() << "was loaded";
  } catch (const NoneCanBeContinued& none) {
    EXPECT_EQ(none.code(), Exit::bad_input);
    EXPECT_THAT(none.what(), HasSubstr("no samples of step 20"));
    ASSERT_EQ(none.rejected().size(), 3U);
    EXPECT_EQ(none.rejected()[0].file, checkpoint_name(30));
    EXPECT_THAT(none.rejected()[0].why, HasSubstr("damaged"));
    EXPECT_EQ(none.rejected()[1].why, "no samples of step 20");
    EXPECT_EQ(none.rejected()[2].why, "no samples of step 10");
  }
}

TEST_F(Resume, OtherLayoutVersionIsRejectedByName) {
  save(10);
  save(20);
  damage(20, [](std::string& content) {
    // A well-formed file of another version: both texts say so, checksum and seal are right.
    const std::string entry = "\"layout\": 1";
    const std::size_t first = content.find(entry);
    const std::size_t second = content.find(entry, first + 1);
    const std::size_t begin = content.rfind('{', content.find("\"lattice\":"));
    const std::size_t end = content.find('\n', content.find("\"metadata_checksum\"")) + 3;  // "\n}\n"
    const std::string before = hex(text_checksum(std::string_view(content).substr(begin, end - begin)));
    for (const std::size_t at : {first, second}) content[at + entry.size() - 1] = '2';
    const std::string after = hex(text_checksum(std::string_view(content).substr(begin, end - begin)));
    content.replace(content.find(before), before.size(), after);
  });
  write_seal(files, place.directory / checkpoint_name(20), comm);
  const Resumed resumed = load();
  EXPECT_EQ(resumed.metadata->step, 10);
  EXPECT_THAT(resumed.rejected[0].why, HasSubstr("layout version 2 (written by rouleau 0.1.0), this solver reads 1"));
}

TEST_F(Resume, OtherLatticeIsRejectedBeforeAnythingIsRead) {
  save(10, {7, 6, 9});
  EXPECT_THAT(refusal().what(), HasSubstr("its lattice is 7 x 6 x 9, the run's is 7 x 6 x 8"));
}

TEST_F(Resume, OtherPrecisionIsRejected) {
  SmallState<double> state(size, block_of(size, 0, comm.rank(), comm.size()));
  state.fill(10);
  metadata.step = 10;
  save_checkpoint(place, comm, state.list(), metadata);
  EXPECT_THAT(refusal().what(), HasSubstr("fluid/f has another type or shape"));
}

TEST_F(Resume, MissingAndExtraItemsAreRejected) {
  save(10);
  PersistentState list = loaded.list();
  list.replicated_items.pop_back();
  try {
    load_newest(files, place.directory, comm, expected, list);
    FAIL() << "was loaded";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("it holds sampler/nothing, which this run does not have"));
  }
  list = loaded.list();
  std::vector<double> more(1);
  list.replicated_items.push_back({"sampler/more", ElementType::f64, {1}, more.data()});
  try {
    load_newest(files, place.directory, comm, expected, list);
    FAIL() << "was loaded";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("it lacks sampler/more"));
  }
}

TEST_F(Resume, FileThatMayBeReadableLaterIsNotPassedOver) {
  save(10);
  files.failing_call = "pread";
  files.failing_errno = ENOLCK;
  EXPECT_EQ(refusal().code(), Exit::io);
}

TEST_F(Resume, MediumThatLostBytesIsDamage) {
  save(10);
  save(20);
  files.failing_call = "pread";
  files.failing_errno = EIO;
  files.failing_preads = 4;  // each of the attempts to read the first bytes
  const Resumed resumed = load();
  ASSERT_TRUE(resumed.metadata.has_value());
  EXPECT_EQ(resumed.metadata->step, 10);
  EXPECT_THAT(resumed.rejected.at(0).why, HasSubstr("the medium cannot read"));
}

TEST_F(Resume, MediumThatCanReadNoCheckpointAtAllMayDoSoLater) {
  save(10);
  files.failing_call = "pread";
  files.failing_errno = EIO;
  EXPECT_EQ(refusal().code(), Exit::io);
}

}  // namespace
}  // namespace rouleau::testing
