// SPDX-License-Identifier: BSD-3-Clause
// Inspecting a checkpoint and taking a cell out of it.
#include "storage/inspect.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "storage/checkpoint.hpp"
#include "support/small_state.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::testing {
namespace {

using ::testing::HasSubstr;
const Int3 size{5, 4, 3};

class Inspect : public ::testing::Test {
 protected:
  Communicator comm;
  TemporaryDirectory directory;
  FileSystem& files = posix_file_system();
  SmallState<float> state{size, Block{{0, 0, 0}, size}};

  std::filesystem::path save(const PersistentState& list) {
    return save_checkpoint({files, directory.path() / "checkpoints", [] {}, 3}, comm, list, small_metadata(10)).file;
  }
  void SetUp() override { state.fill(10); }
};

TEST_F(Inspect, ReportsMetadataItemsAndCells) {
  const std::filesystem::path file = save(state.list());
  const CheckpointReport report = inspect_checkpoint(files, file);
  EXPECT_EQ(report.metadata, small_metadata(10));
  EXPECT_EQ(report.lattice, size);
  EXPECT_EQ(report.bytes, std::filesystem::file_size(file));
  ASSERT_EQ(report.items.size(), 9U);
  EXPECT_EQ(report.items[0].name, "fluid/f");
  EXPECT_EQ(report.items[0].type, ElementType::f32);
  EXPECT_EQ(report.items[0].shape, (std::vector<std::uint64_t>{5, 3, 4, 5}));
  EXPECT_EQ(report.items[0].bytes, 5U * 60U * 4U);
  EXPECT_EQ(report.items[0].checksums.size(), 5U);
  ASSERT_EQ(report.cells.size(), 2U);
  EXPECT_EQ(report.cells[0].vertices, 4);
  EXPECT_EQ(report.cells[1].triangles, 4);
  double mean = 0;
  for (int v = 5; v < 9; ++v) mean += state.X[static_cast<std::size_t>(v)] / 4;
  EXPECT_NEAR(report.cells[1].centre[0], mean, 1e-15);  // rounding of four terms below 1
  EXPECT_EQ(report.cells[0].lower[2], *std::min_element(state.X.begin() + 18, state.X.begin() + 22));
  EXPECT_EQ(report.cells[0].upper[1], *std::max_element(state.X.begin() + 9, state.X.begin() + 13));
}

TEST_F(Inspect, CellIsReadWithItsOwnVertexNumbers) {
  const SavedCell cell = read_cell(files, save(state.list()), 1);
  EXPECT_EQ(cell.node_spacing_um, 0.5);
  ASSERT_EQ(cell.surface.X.size(), 4U);
  for (std::size_t v = 0; v < 4; ++v) {
    EXPECT_EQ(cell.surface.X.x[v], state.X[5 + v]);
    EXPECT_EQ(cell.surface.X.z[v], state.X[18 + 5 + v]);
    EXPECT_EQ(cell.X_reference.y[v], state.X_reference[9 + 5 + v]);
  }
  EXPECT_EQ(std::vector<int>(cell.surface.triangles.a.begin(), cell.surface.triangles.a.end()),
            (std::vector<int>{0, 1, 2, 3}));
}

TEST_F(Inspect, CellThatIsNotThereIsNamed) {
  const std::filesystem::path file = save(state.list());
  try {
    static_cast<void>(read_cell(files, file, 2));
    FAIL() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::bad_input);
    EXPECT_THAT(error.what(), HasSubstr("there is no cell 2; it holds 2"));
  }
}

TEST_F(Inspect, RangesThatLeaveTheArraysAreRefused) {
  state.ranges[5] = 10;
  const std::filesystem::path file = save(state.list());
  EXPECT_THROW(static_cast<void>(read_cell(files, file, 1)), Error);
  EXPECT_THROW(static_cast<void>(inspect_checkpoint(files, file)), Error);
}

TEST_F(Inspect, TriangleOfAnotherCellsVertexIsRefused) {
  state.triangles[2] = 3;
  EXPECT_THROW(static_cast<void>(read_cell(files, save(state.list()), 1)), Error);
}

TEST_F(Inspect, RunWithoutACellHasNone) {
  PersistentState list = state.list();
  std::erase_if(list.replicated_items, [](const ReplicatedItem& item) { return item.name.starts_with("cells/"); });
  const std::filesystem::path file = save(list);
  EXPECT_TRUE(inspect_checkpoint(files, file).cells.empty());
  try {
    static_cast<void>(read_cell(files, file, 0));
    FAIL() << "was read";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("written by a run without a cell"));
  }
}

TEST_F(Inspect, FileThatIsNoCheckpointIsBadInput) {
  set_content(directory.path() / "a.h5", "solid cube\n");
  try {
    static_cast<void>(inspect_checkpoint(files, directory.path() / "a.h5"));
    FAIL() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::bad_input);
    EXPECT_THAT(error.what(), HasSubstr("a.h5: not a checkpoint"));
  }
  EXPECT_THROW(static_cast<void>(inspect_checkpoint(files, directory.path() / "missing.h5")), Error);
}

}  // namespace
}  // namespace rouleau::testing
