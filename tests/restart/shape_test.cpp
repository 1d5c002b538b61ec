// SPDX-License-Identifier: BSD-3-Clause
// `rouleau-solver shape`: cells of checkpoints and snapshots for programs that draw them.
#include <gmock/gmock.h>

#include <cmath>

#include "restart/small_run.hpp"
#include "support/hdf5_array.hpp"

namespace rouleau::testing {
namespace {

using nlohmann::json;

/// Two cells; fields and cells at steps 0, 20, 40.
const SmallRun& run() {
  static const SmallRun the_run = [] {
    return SmallRun(Changes{{"output.snapshot_interval_s", "2.5e-5"},
                            {"cell.2.shape", "sphere"},
                            {"cell.2.radius_um", "4"},
                            {"cell.2.position_x_um", "7"},
                            {"cell.2.subdivisions", "3"},
                            {"cell.rotation_angle_deg", "90"}});
  }();
  static const bool finished = (the_run.finish(), true);
  static_cast<void>(finished);
  return the_run;
}

Finished shape(const std::string& file, const std::vector<std::string>& options = {}) {
  std::vector<std::string> words{ROULEAU_SOLVER, "shape", run().path(file).string()};
  words.insert(words.end(), options.begin(), options.end());
  return run_program(words);
}

TEST(Shape, IsTheSameFromCheckpointAndSnapshot) {
  const Finished of_checkpoint = shape("checkpoints/000000000040.h5");
  const Finished of_snapshot = shape("snapshots/cells-000000000040.h5");
  ASSERT_EQ(of_checkpoint.code, 0) << of_checkpoint.err;
  ASSERT_EQ(of_snapshot.code, 0) << of_snapshot.err;
  const json a = json::parse(of_checkpoint.out), b = json::parse(of_snapshot.out);
  EXPECT_EQ(a.at("contract"), 1);
  EXPECT_EQ(a.at("step"), 40);
  EXPECT_DOUBLE_EQ(a.at("time_s").get<double>(), 5e-5);
  EXPECT_EQ(a.at("box_um"), (json{16.0, 12.0, 10.0}));
  for (const char* name : {"step", "time_s", "box_um", "node_spacing_um"}) EXPECT_EQ(a.at(name), b.at(name)) << name;
  ASSERT_EQ(a.at("cells").size(), 2u);
  for (std::size_t c = 0; c < 2; ++c) {
    const json &in_a = a["cells"][c], &in_b = b.at("cells").at(c);
    EXPECT_EQ(in_a.at("triangles"), in_b.at("triangles"));
    EXPECT_EQ(in_a.at("triangles").size(), 1280u);
    ASSERT_EQ(in_a.at("vertices_um").size(), 642u);
    for (std::size_t v = 0; v < 642; ++v)
      for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(in_a["vertices_um"][v][axis].get<double>(), in_b.at("vertices_um")[v][axis].get<double>(), 3e-6);
  }
}

TEST(Shape, SliceIsTheFlagsThroughTheFirstCell) {
  const auto inside = hdf5_array<int>(run().path("snapshots/000000000040.h5"), "inside").values;  // [15][18][24]
  for (const std::string normal : {"y", "z"}) {
    const Finished finished = shape("checkpoints/000000000040.h5", {"--slice", normal});
    ASSERT_EQ(finished.code, 0) << finished.err;
    const json answer = json::parse(finished.out);
    const json& slice = answer.at("slice");
    double centre = 0;
    for (const auto& v : answer["cells"][0]["vertices_um"]) centre += v[normal == "y" ? 1 : 2].get<double>() / 642;
    EXPECT_NEAR(slice.at("at_um").get<double>(), centre, 1.0 / 3) << "half a spacing";
    const auto plane = static_cast<std::size_t>(std::lround(slice["at_um"].get<double>() * 1.5 - 0.5));
    ASSERT_EQ(slice.at("inside").size(), normal == "y" ? 15u : 18u);
    int flagged = 0;
    for (std::size_t row = 0; row < slice["inside"].size(); ++row) {
      const auto digits = slice["inside"][row].get<std::string>();
      ASSERT_EQ(digits.size(), 24u);
      for (std::size_t i = 0; i < 24; ++i) {
        const std::size_t node = normal == "y" ? (row * 18 + plane) * 24 + i : (plane * 18 + row) * 24 + i;
        EXPECT_EQ(digits[i] - '0', inside[node]);
        flagged += digits[i] - '0';
      }
    }
    EXPECT_GT(flagged, 20);
  }
}

TEST(Shape, RefusesWhatItCannotShow) {
  const auto expect = [](const Finished& finished, int code, const std::string& text) {
    EXPECT_EQ(finished.code, code);
    EXPECT_THAT(finished.err, ::testing::HasSubstr(text));
    EXPECT_EQ(finished.out, "");
  };
  expect(shape("snapshots/000000000040.h5"), 65, "vertices_um");
  expect(shape("snapshots/cells-000000000040.h5", {"--slice", "y"}), 65, "checkpoint");
  expect(shape("run.ini"), 65, "run.ini");
  expect(shape("none.h5"), 74, "none.h5");
  expect(shape("checkpoints/000000000040.h5", {"--slice", "x"}), 64, "y or z");
  std::string damaged = content_of(run().path("checkpoints/000000000040.h5"));
  damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 8);
  set_content(run().path("damaged.h5"), damaged);
  expect(shape("damaged.h5"), 65, "damaged.h5");
}

}  // namespace
}  // namespace rouleau::testing
