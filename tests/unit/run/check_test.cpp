// SPDX-License-Identifier: BSD-3-Clause
// The answer of `check`, the conversion table, the version text.
#include "run/check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run/conversion_table.hpp"
#include "run/parameter_table.hpp"
#include "run/version.hpp"
#include "unit/run/run_text.hpp"

namespace rouleau {
namespace {

using test::Read;
using test::RunText;
using testing::HasSubstr;

TEST(CheckAnswer, HoldsWhatTheContractPromises) {
  const Read r{RunText{.fluid = "lambda = 4.750", .output = "sample_interval_steps = 1000"}};
  const auto json = check_json(r.run, r.lattice, {5120, 2562, 1, 35000000, 0}, {"careful"});
  for (const char* key : {"contract", "version", "git", "parameters", "identity", "steps", "time_step_us", "nodes",
                          "triangles", "vertices", "cells", "end_time_s", "samples", "checkpoint_bytes",
                          "snapshot_bytes", "node_spacing_um", "relative_cost_per_step", "warnings"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["contract"], 1);
  EXPECT_EQ(json["nodes"], 128 * 36 * 30);
  EXPECT_EQ(json["identity"], r.run.identity);
  EXPECT_EQ(json["samples"], r.lattice.steps / 1000 + 1);  // step 0 is sampled
  EXPECT_EQ(json["parameters"].size(), parameter_table().size());
  const auto& lambda = json["parameters"][0];
  EXPECT_EQ(lambda["name"], "fluid.lambda");
  EXPECT_EQ(lambda["value"], "4.75");
  EXPECT_EQ(lambda["default"], "5");
  EXPECT_EQ(lambda["kind"], "identity");
  EXPECT_EQ(lambda["given"], true);
  for (const auto& p : json["parameters"])
    EXPECT_EQ(p["kind"] == "free", p["name"] == "time.end_time_s" ||
                                       p["name"].get<std::string>().starts_with("output.") ||
                                       p["name"].get<std::string>().starts_with("bounds."));
}

TEST(ConversionTable, ShowsEachNumberInBothSystems) {
  const Read r{RunText{}};
  const std::string text =
      conversion_table(r.run, r.lattice, r.units, {{0.452, 0.777, 1.035, Vec3::Zero(), Vec3::Zero()}});
  for (const char* part :
       {"0.333333 um", "0.154321 us", "128 x 36 x 30 = 138240 nodes", "Mach number", "433424 Pa/m",
        "kappa_A dt / (mu dx)", "0.1929", "0.259 (0.151, 0.345) um", "0.777 (0.452, 1.03)", "60000260 steps"})
    EXPECT_THAT(text, HasSubstr(part));
}

TEST(ConversionTable, LeavesOutTheMembraneWithoutACell) {
  const Read r{RunText{.cell = "shape = none"}};
  EXPECT_THAT(conversion_table(r.run, r.lattice, r.units, {}), testing::Not(HasSubstr("kappa")));
}

TEST(VersionText, NamesProgramCompilerAndLibraries) {
  const std::string text = version_text("1.10.8", "Open MPI 4.1.4");
  EXPECT_THAT(text, HasSubstr(std::string("rouleau-solver ") + version()));
  EXPECT_THAT(text, HasSubstr(git_hash()));
  for (const char* part : {"built with", "bits", "Eigen", "Boost 1.", "fmt", "xxHash", "HDF5 1.10.8", "Open MPI 4.1.4"})
    EXPECT_THAT(text, HasSubstr(part));
}

}  // namespace
}  // namespace rouleau
