// SPDX-License-Identifier: BSD-3-Clause
// A new run may start from the deformed cell of a checkpoint: other viscosity contrast, other lattice, other channel.
#include <gtest/gtest.h>

#include <sstream>

#include "restart/small_run.hpp"

namespace rouleau::testing {
namespace {

/// Column `name` of the first sample.
double first_sample(const SmallRun& run, const std::string& name) {
  std::istringstream lines(run.samples());
  std::string header, row;
  std::getline(lines, header);
  std::getline(lines, row);
  std::istringstream names(header), values(row);
  std::string each, value;
  while (std::getline(names, each, ',') && std::getline(values, value, ','))
    if (each == name) return std::stod(value);
  ADD_FAILURE() << "no column " << name;
  return 0;
}

/// The same of the last sample.
double last_sample(const SmallRun& run, const std::string& name) {
  const std::string all = run.samples();
  const auto header_end = all.find('\n');
  const auto last = all.rfind('\n', all.size() - 2);
  std::istringstream names(all.substr(0, header_end)), values(all.substr(last + 1));
  std::string each, value;
  while (std::getline(names, each, ',') && std::getline(values, value, ','))
    if (each == name) return std::stod(value);
  ADD_FAILURE() << "no column " << name;
  return 0;
}

Changes from_checkpoint(const SmallRun& source) {
  return {{"cell.shape", "checkpoint"}, {"cell.mesh_file", source.path("checkpoints/000000002000.h5").string()}};
}

/// The same cell on a lattice of 1/2 um, not turned.
Changes on_a_finer_lattice(const SmallRun& source) {
  Changes changes = from_checkpoint(source);
  changes["numerics.node_spacing_um"] = "1/2";
  changes["numerics.time_step_us"] = "0.75";
  changes["channel.length_x_um"] = "20";
  changes["cell.position_x_um"] = "10";
  changes["cell.rotation_angle_deg"] = "0";
  changes["cell.subdivisions"] = "";
  return changes;
}

class NewStart : public ::testing::Test {
 protected:
  NewStart() : source_(Changes{{"flow.mean_velocity_mm_per_s", "3"}}) {
    source_.set_steps(2000);
    source_.finish();
  }
  SmallRun source_;
};

TEST_F(NewStart, KeepsTheDeformedShapeOnAFinerLattice) {
  Changes changes = on_a_finer_lattice(source_);
  changes["fluid.lambda"] = "2";
  changes["output.sample_interval_steps"] = "40";
  SmallRun next(changes);
  next.finish(2);
  // The shape measure is that of the last sample of the source, but for the few steps since.
  EXPECT_NEAR(first_sample(next, "asphericity"), last_sample(source_, "asphericity"), 1e-3);
  EXPECT_NEAR(first_sample(next, "area_ratio"), last_sample(source_, "area_ratio"), 1e-3);
  EXPECT_GT(std::abs(last_sample(source_, "asphericity") - first_sample(source_, "asphericity")), 5e-3);
  // Flags by ray casting agree with the volume within the staircase of the lattice.
  EXPECT_NEAR(first_sample(next, "inside_ratio"), 1, 0.02);
}

TEST_F(NewStart, KeepsItsPlaceAcrossTheChannelIfAsked) {
  Changes changes = on_a_finer_lattice(source_);
  changes["cell.offset_y_um"] = changes["cell.offset_z_um"] = "";
  changes["cell.offset_from"] = "checkpoint";
  SmallRun next(changes);
  next.finish(2);
  for (const char* column : {"y_um", "z_um", "d_um"})
    EXPECT_NEAR(first_sample(next, column), last_sample(source_, column), 1e-6) << column;
  EXPECT_GT(last_sample(source_, "d_um"), 0.1) << "the cell is on the axis: the test proves nothing";
}

TEST_F(NewStart, DamagedSourceIsRefused) {
  const auto file = source_.path("checkpoints/000000002000.h5");
  std::string bytes = content_of(file);
  bytes.resize(bytes.size() - 1000);
  set_content(file, bytes);
  Changes changes = from_checkpoint(source_);
  changes["cell.subdivisions"] = "";
  SmallRun next(changes);
  EXPECT_EQ(next.run().code, 65);
}

}  // namespace
}  // namespace rouleau::testing
