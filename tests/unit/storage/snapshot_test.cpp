// SPDX-License-Identifier: BSD-3-Clause
// Files of snapshots: what they hold, and that a failure at any call leaves what was there before.
#include "storage/snapshot.hpp"

#include <gtest/gtest.h>

#include <cerrno>
#include <map>
#include <numeric>
#include <regex>

#include "base/error.hpp"
#include "storage/files.hpp"
#include "storage/snapshot_series.hpp"
#include "storage/unfinished.hpp"
#include "support/file_system_double.hpp"
#include "support/hdf5_array.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::testing {
namespace {

template <class T>
std::vector<T> counted(std::size_t n, T first) {
  std::vector<T> values(n);
  std::iota(values.begin(), values.end(), first);
  return values;
}

SnapshotMoment moment(std::int64_t step) { return {step, 1e-6 * static_cast<double>(step), {10, 8, 6}, 0.5}; }

FieldSnapshot fields(std::int64_t step, float first = 1) {
  FieldSnapshot s;
  s.moment = moment(step);
  s.stride = 2;
  s.size = {10, 8, 6};
  s.velocity_mm_per_s = counted<float>(3 * 480, first);
  s.pressure_Pa = counted<float>(480, first);
  s.inside.assign(480, 1);
  s.membrane_force_pN_per_um3 = counted<float>(3 * 480, -first);
  return s;
}

/// Two tetrahedra.
CellSnapshot cells(std::int64_t step, float first = 1) {
  CellSnapshot s;
  s.moment = moment(step);
  s.vertices_um = counted<float>(24, first);
  s.tension_uN_per_m = s.area_strain = s.mean_curvature_per_um = counted<float>(8, first);
  s.force_pN = counted<float>(24, first);
  s.triangles = {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2, 4, 5, 6, 4, 6, 7, 4, 7, 5, 5, 7, 6};
  s.cell = {0, 0, 0, 0, 1, 1, 1, 1};
  s.cell_ranges = {0, 4, 0, 4, 4, 8, 4, 8};
  s.cell_periods = {0, 0, 0, 2, 0, 0};
  return s;
}

class Snapshots : public ::testing::Test {
 protected:
  TemporaryDirectory run;
  std::filesystem::path directory = run.path() / "snapshots";
  FileSystemDouble files;
  SnapshotPlace place{files, directory, [] {}, 3};

  std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> all;
    for (const auto& name : list_directory(posix_file_system(), directory)) all[name] = content_of(directory / name);
    return all;
  }
  template <class Work>
  static Exit code_of(const Work& work, std::string* text = nullptr) {
    try {
      work();
    } catch (const Error& error) {
      if (text != nullptr) *text = error.what();
      return error.code();
    }
    return Exit::finished;
  }
};

TEST_F(Snapshots, FieldsAreArraysThatAnyProgramReads) {
  write_snapshot(place, fields(100));
  const auto file = directory / "000000000100.h5";
  const auto velocity = hdf5_array<double>(file, "velocity_mm_per_s");
  EXPECT_EQ(velocity.shape, (std::vector<hsize_t>{6, 8, 10, 3}));
  EXPECT_EQ(velocity.values[3 * 479 + 2], 1440);
  EXPECT_EQ(hdf5_array<double>(file, "pressure_Pa").shape, (std::vector<hsize_t>{6, 8, 10}));
  EXPECT_EQ(hdf5_array<int>(file, "inside").values, std::vector<int>(480, 1));
  EXPECT_EQ(hdf5_array<double>(file, "membrane_force_pN_per_um3").values[0], -1);
  const SnapshotSummary summary = summarise_snapshot(files, file, SnapshotKind::fields);
  EXPECT_EQ(summary.moment.step, 100);
  EXPECT_EQ(summary.stride, 2);
  EXPECT_EQ(summary.size, (Int3{10, 8, 6}));
}

TEST_F(Snapshots, CellsComeBackAsTheyWere) {
  write_snapshot(place, cells(7));
  const auto file = directory / "cells-000000000007.h5";
  const CellSnapshot back = read_cell_shapes(files, file);
  EXPECT_EQ(back.vertices_um, cells(7).vertices_um);
  EXPECT_EQ(back.triangles, cells(7).triangles);
  EXPECT_EQ(back.cell_ranges, cells(7).cell_ranges);
  EXPECT_EQ(back.cell_periods, cells(7).cell_periods);
  EXPECT_EQ(back.moment.time_s, 7e-6);
  EXPECT_EQ(hdf5_array<int>(file, "cell").values, (std::vector<int>{0, 0, 0, 0, 1, 1, 1, 1}));
  EXPECT_EQ(hdf5_array<double>(file, "force_pN").values[23], 24);
}

TEST_F(Snapshots, SameStateGivesTheSameBytes) {
  write_snapshot(place, fields(100));
  write_snapshot(place, cells(100));
  const auto first = contents();
  write_snapshot(place, fields(100));
  write_snapshot(place, cells(100));
  EXPECT_EQ(contents(), first);
  EXPECT_EQ(first.size(), 2u);
}

TEST_F(Snapshots, NamesAreThoseOfTheirKindAlone) {
  EXPECT_EQ(step_of_snapshot(SnapshotKind::fields, "000000000100.h5"), 100);
  EXPECT_EQ(step_of_snapshot(SnapshotKind::cells, "cells-000000000100.h5"), 100);
  for (const char* name :
       {"100.h5", "000000000100.h5.a1.tmp", "cells-000000000100.h5", "fields.xdmf", "0000000001oo.h5"})
    EXPECT_FALSE(step_of_snapshot(SnapshotKind::fields, name)) << name;
  EXPECT_FALSE(step_of_snapshot(SnapshotKind::cells, "000000000100.h5"));
}

TEST_F(Snapshots, FullDiskIsOneErrorAndDamagesNothing) {
  write_snapshot(place, fields(100));
  const auto before = contents();
  for (const char* call : {"open", "pwrite", "fsync", "close", "rename"}) {
    files.failing_call = call;
    files.failing_errno = ENOSPC;
    std::string text;
    EXPECT_EQ(code_of([&] { write_snapshot(place, fields(200)); }, &text), Exit::io) << call;
    EXPECT_NE(text.find("No space left"), std::string::npos) << text;
    EXPECT_TRUE(contents() == before) << call;
  }
  files.failing_call.clear();
  files.claimed_space = 1000;
  std::string text;
  EXPECT_EQ(code_of([&] { write_snapshot(place, fields(200)); }, &text), Exit::io);
  EXPECT_NE(text.find("a snapshot needs"), std::string::npos) << text;
  EXPECT_EQ(contents(), before);
}

TEST_F(Snapshots, DeathAtAnyCallLeavesTheOldOrTheNewFile) {
  write_snapshot(place, fields(100, 1));
  const std::string old_bytes = content_of(directory / "000000000100.h5");
  bool reached_the_end = false;
  bool was_new = false;
  for (int call = 1; !reached_the_end; ++call) {
    FileSystemDouble dying;
    dying.die_at = call;
    const SnapshotPlace there{dying, directory, [] {}, 4};
    reached_the_end = code_of([&] { write_snapshot(there, fields(100, 2)); }) == Exit::finished;
    // The next attempt.
    remove_unfinished(posix_file_system(), directory, 5);
    const auto left = contents();
    ASSERT_EQ(left.size(), 1u) << call;
    const auto pressure = hdf5_array<double>(directory / "000000000100.h5", "pressure_Pa").values;
    ASSERT_TRUE(pressure[0] == 1 || pressure[0] == 2) << call;
    ASSERT_EQ(pressure[479], pressure[0] + 479) << call;
    was_new = was_new || pressure[0] == 2;
    set_content(directory / "000000000100.h5", old_bytes);
  }
  EXPECT_TRUE(was_new);
}

TEST_F(Snapshots, SupersededAttemptChangesNothing) {
  write_snapshot(place, fields(100));
  const auto before = contents();
  for (const int last_allowed : {0, 1}) {
    int asked = 0;
    const SnapshotPlace older{files, directory,
                              [&] {
                                if (asked++ >= last_allowed) fail(Exit::superseded, "taken over");
                              },
                              2};
    EXPECT_EQ(code_of([&] { write_snapshot(older, fields(100, 5)); }), Exit::superseded);
    EXPECT_EQ(contents(), before);
  }
}

TEST_F(Snapshots, ChangedBytesAreNoticedOrMeanNothing) {
  write_snapshot(place, cells(7));
  const auto file = directory / "cells-000000000007.h5";
  const std::string sound = content_of(file);
  int noticed = 0, tried = 0;
  for (std::size_t byte = 0; byte < sound.size(); byte += 5) {
    std::string damaged = sound;
    damaged[byte] = static_cast<char>(damaged[byte] ^ 0x41);
    set_content(file, damaged);
    ++tried;
    const Exit code = code_of([&] {
      const CellSnapshot back = read_cell_shapes(files, file);
      EXPECT_EQ(back.vertices_um, cells(7).vertices_um) << byte;
      EXPECT_EQ(back.triangles, cells(7).triangles) << byte;
      EXPECT_EQ(back.cell_ranges, cells(7).cell_ranges) << byte;
    });
    EXPECT_TRUE(code == Exit::finished || code == Exit::bad_input) << byte;
    noticed += code == Exit::bad_input ? 1 : 0;
  }
  EXPECT_GT(noticed, tried / 20);  // most of a file so small is room that HDF5 does not use
}

TEST_F(Snapshots, NoSnapshotIsNoSnapshot) {
  write_snapshot(place, fields(100));
  const auto of_fields = directory / "000000000100.h5";
  EXPECT_EQ(code_of([&] { (void)read_cell_shapes(files, of_fields); }), Exit::bad_input);
  set_content(directory / "torn.h5", content_of(of_fields).substr(0, 900));
  EXPECT_EQ(code_of([&] { (void)summarise_snapshot(files, directory / "torn.h5", SnapshotKind::fields); }),
            Exit::bad_input);
  EXPECT_EQ(code_of([&] { (void)summarise_snapshot(files, directory / "none.h5", SnapshotKind::fields); }), Exit::io);
}

/// Every reference of a series is to an array of that shape and type.   returns how many there are
int expect_references_hold(const std::filesystem::path& series) {
  const std::string text = content_of(series);
  const std::regex item(
      R"re(Format="HDF" Dimensions="([0-9 ]+)" NumberType="(\w+)" Precision="(\d)">([^:]+):/(\w+)<)re");
  int references = 0;
  for (auto at = std::sregex_iterator(text.begin(), text.end(), item); at != std::sregex_iterator(); ++at) {
    const auto array = hdf5_array<double>(series.parent_path() / (*at)[4].str(), (*at)[5]);
    std::string shape;
    for (const hsize_t n : array.shape) shape += (shape.empty() ? "" : " ") + std::to_string(n);
    EXPECT_EQ(shape, (*at)[1]) << at->str();
    ++references;
  }
  return references;
}

TEST_F(Snapshots, SeriesNamesWhatIsOnTheDisk) {
  SnapshotSeries field_series(SnapshotKind::fields), cell_series(SnapshotKind::cells);
  for (const std::int64_t step : {0, 200, 100}) {
    write_snapshot(place, fields(step));
    field_series.write(place, snapshot_name(SnapshotKind::fields, step));
    write_snapshot(place, cells(step));
    cell_series.write(place, snapshot_name(SnapshotKind::cells, step));
  }
  EXPECT_EQ(expect_references_hold(directory / "fields.xdmf"), 3 * 4);
  EXPECT_EQ(expect_references_hold(directory / "cells.xdmf"), 3 * 7);
  const std::string text = content_of(directory / "fields.xdmf");
  EXPECT_LT(text.find("Value=\"0\""), text.find("Value=\"0.0001\""));
  EXPECT_LT(text.find("Value=\"0.0001\""), text.find("Value=\"0.0002\""));

  // A later attempt writes the same, and knows of files that are gone, thinned otherwise or damaged.
  SnapshotSeries later(SnapshotKind::fields);
  later.write(place, "");
  EXPECT_EQ(content_of(directory / "fields.xdmf"), text);
  std::filesystem::remove(directory / "000000000000.h5");
  FieldSnapshot thinner = fields(100);
  thinner.size = {5, 4, 3};
  write_snapshot(place, thinner);
  later.write(place, snapshot_name(SnapshotKind::fields, 100));
  EXPECT_EQ(expect_references_hold(directory / "fields.xdmf"), 2 * 4);
  set_content(directory / "000000000300.h5", "torn");
  ::testing::internal::CaptureStderr();
  later.write(place, "");
  EXPECT_NE(::testing::internal::GetCapturedStderr().find("000000000300.h5"), std::string::npos);
  EXPECT_EQ(expect_references_hold(directory / "fields.xdmf"), 2 * 4);
}

TEST_F(Snapshots, SizesAreThoseOfTheArrays) {
  EXPECT_EQ(uncompressed_field_bytes({10, 8, 6}), 480 * 29u);
  EXPECT_EQ(uncompressed_cell_bytes(8, 8, 2), 8 * 36u + 8 * 16u + 2 * 28u);
}

}  // namespace
}  // namespace rouleau::testing
