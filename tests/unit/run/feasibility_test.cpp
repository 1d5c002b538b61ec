// SPDX-License-Identifier: BSD-3-Clause
// What is warned about, and that sound runs are left in peace. Refusals are in tests/contract/bad_run_files.
#include "run/feasibility.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "unit/run/run_text.hpp"

namespace rouleau {
namespace {

using test::Read;
using test::RunText;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(Warnings, AreNoneForThePapersChannelAndKernelWithACentredCell) {
  EXPECT_THAT(Read(RunText{.numerics = "kernel = 2-point\nadvection = averaged"}).warnings(), IsEmpty());
}

TEST(Warnings, NameTheClearanceOfThePapersStart) {
  // 5 - 0.833 - 4 um = 0.5 node spacings with the disc upright, and 1.5 in y
  const auto warnings =
      Read(RunText{.cell = "offset_y_um = 1.5\noffset_z_um = 5/6\nrotation_angle_deg = 90"}).warnings();
  EXPECT_THAT(warnings, Contains(AllOf(HasSubstr("offset_z_um"), HasSubstr("0.5 node spacings"))));
  EXPECT_THAT(warnings, Contains(AllOf(HasSubstr("offset_y_um"), HasSubstr("1.5 node spacings"))));
}

TEST(Warnings, NameEachDoubtfulChoice) {
  const auto expect_warning = [](const RunText& text, const std::string& part) {
    EXPECT_THAT(Read(text).warnings(), Contains(HasSubstr(part)));
  };
  expect_warning({.numerics = "tau_plasma = 2.5"}, "outside the usual window");
  expect_warning({.numerics = "collision = mrt\nomega_q = 0.1"}, "misplaces the walls");
  expect_warning({.numerics = "magic_lambda = 4"}, "misplaces the walls");
  expect_warning({.fluid = "lambda = 20", .numerics = "collision = mrt"}, "inaccurate at the membrane");
  expect_warning({.numerics = "correction_interval = 0"}, "wrong inside flags");
  expect_warning({.spacing = "node_spacing_um = 1/3\ntime_step_us = 0.5"}, "inflates the Reynolds number");
  expect_warning({.numerics = "tau_plasma = 1.5",
                  .lengths = "length_x_um = 42\nlength_y_um = 12\nlength_z_um = 10",
                  .spacing = "node_spacing_um = 1/2\ntime_step_us = 25/36"},
                 "act 0.32 um thicker than it is with this kernel, 0.079 radii: above 0.03");
  expect_warning({.lengths = "length_x_um = 15\nlength_y_um = 12\nlength_z_um = 10"}, "periodic image");
  expect_warning({.flow = "driving = shear\nshear_rate_per_s = 100"}, "no uniform shear rate");
}

TEST(WallError, IsZeroAtThreeSixteenthsAndThatOfTheRatesWithMrt) {
  EXPECT_EQ(Read(RunText{}).numbers().wall_error, 0);
  // All free rates 1: Lambda = 1.5 nu = 1/4 at nu = 1/6, so (4 - 3) / (3 30^2)
  EXPECT_NEAR(Read(RunText{.numerics = "collision = mrt"}).numbers().wall_error, 1.0 / 2700, 1e-15);
}

TEST(Stiffness, LimitIsHalfAsHighForAdamsBashforth) {
  const RunText text{.numerics = "tau_plasma = 3", .spacing = "node_spacing_um = 1/3\ntime_step_us = 1.2"};  // 1.5
  EXPECT_NO_THROW(Read(text).warnings());
  RunText second = text;
  second.numerics += "\nadvection = adams_bashforth";
  EXPECT_THROW(Read(second).warnings(), Error);
}

/// The paper's time step times `factor`, tau - 1/2 growing alike.
RunText at_step(double factor, const std::string& numerics) {
  RunText text;
  text.numerics = fmt::format("tau_plasma = {}\n{}", 0.5 + 0.5 * factor, numerics);
  text.spacing = fmt::format("node_spacing_um = 1/3\ntime_step_us = {}", factor * 0.154321);
  return text;
}

std::string refusal(const RunText& text) {
  try {
    static_cast<void>(Read(text).warnings());
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(SafeCombinations, AreLeftInPeace) {
  const auto about_the_kernel = Contains(HasSubstr("numerics.kernel = "));
  EXPECT_THAT(Read(at_step(8, "kernel = 4-point")).warnings(), Not(about_the_kernel));
  EXPECT_THAT(Read(at_step(4, "kernel = 3-point\nadvection = averaged")).warnings(), Not(about_the_kernel));
  EXPECT_THAT(Read(at_step(2, "kernel = 2-point\nadvection = averaged")).warnings(), Not(about_the_kernel));
}

TEST(SafeCombinations, ThatWereLostAtOnceAreRefusedWithTheNearestThatHeld) {
  EXPECT_THAT(refusal(at_step(1, "kernel = 2-point")),
              AllOf(HasSubstr("numerics.kernel = 2-point with advection = euler loses"),
                    HasSubstr("Choose kernel = 2-point with advection = averaged or kernel = 3-point"),
                    HasSubstr("bounds.unsafe_combination = run")));
  EXPECT_THAT(refusal(at_step(4, "kernel = 2-point\nadvection = averaged")),
              AllOf(HasSubstr("Choose kernel = 3-point with advection = averaged or kernel = 4-point"),
                    HasSubstr("smaller by 1.99")));
  EXPECT_THAT(refusal(at_step(10, "kernel = 4-point")), HasSubstr("Choose time_step_us and tau_plasma - 1/2 smaller"));
}

TEST(SafeCombinations, ThatWereNotTriedOrLostLaterAreWarnedOf) {
  const RunText soft{.membrane = "area_ratio = 10", .numerics = "kernel = 2-point"};
  EXPECT_THAT(Read(soft).warnings(), Contains(AllOf(HasSubstr("may lose"), HasSubstr("held at no stiffness"))));
  EXPECT_THAT(Read(at_step(3, "kernel = 2-point\nadvection = averaged")).warnings(), Contains(HasSubstr("may lose")));
}

TEST(SafeCombinations, OfASoftAreaAreRefusedWhereTheyWereAlwaysLost) {
  const RunText wide{.membrane = "area_ratio = 10", .numerics = "kernel = 4-point"};
  EXPECT_THAT(refusal(wide), AllOf(HasSubstr("membrane.area_ratio = 10 loses the cell with kernel = 4-point"),
                                   HasSubstr("100 held"), HasSubstr("bounds.unsafe_combination = run")));
  const RunText narrow{.membrane = "area_ratio = 10", .numerics = "kernel = 2-point\nadvection = averaged"};
  EXPECT_THAT(Read(narrow).warnings(), Contains(HasSubstr("membrane.area_ratio = 10 may lose the cell")));
  const RunText stiff{.membrane = "area_ratio = 100", .numerics = "kernel = 4-point"};
  EXPECT_THAT(Read(stiff).warnings(), Not(Contains(HasSubstr("lose the cell"))));
}

TEST(SafeCombinations, ThatAreRefusedCanBeRunKnowingly) {
  RunText text = at_step(1, "kernel = 2-point");
  text.bounds = "unsafe_combination = run";
  EXPECT_THAT(Read(text).warnings(), Contains(HasSubstr("loses a membrane")));
}

class MeshFeasibility : public testing::Test {
 protected:
  // The 5120-triangle cell at dx = 1/3 um: mean 0.777, min 0.452, max 1.035 node spacings.
  const MeshFacts paper_{0.452, 0.777, 1.035, {60, 6, 10}, {68, 30, 20}};

  static std::vector<std::string> warnings(const RunText& text, const MeshFacts& mesh) {
    const Read r{text};
    return check_mesh_feasibility(r.run, r.lattice, 0, mesh);
  }
};

TEST_F(MeshFeasibility, AcceptsThePapersMeshWithTheWideKernel) { EXPECT_THAT(warnings({}, paper_), IsEmpty()); }

TEST_F(MeshFeasibility, WarnsOfEdgesOutsideTheirWindowAndRefusesLongOnes) {
  MeshFacts mesh = paper_;
  mesh.edge_mean = 0.39;
  EXPECT_THAT(warnings({}, mesh), Contains(HasSubstr("Coarsen the mesh")));
  mesh.edge_mean = 1.3;
  EXPECT_THAT(warnings({}, mesh), Contains(HasSubstr("Refine the mesh")));
  mesh.edge_max = 2.01;
  EXPECT_THROW(warnings({}, mesh), Error);
}

TEST_F(MeshFeasibility, ChecksTheBoxOfALoadedMesh) {
  const auto file = std::filesystem::temp_directory_path() / "mesh_feasibility_test.off";
  std::ofstream(file) << "OFF";
  const RunText text{.cell = "shape = mesh\nmesh_file = " + file.string()};
  EXPECT_THAT(warnings(text, paper_), IsEmpty());
  MeshFacts mesh = paper_;
  mesh.upper[2] = 29.6;  // the wall stands at 29.5
  EXPECT_THROW(warnings(text, mesh), Error);
  mesh = paper_;
  mesh.lower = {60, 10, 10};
  mesh.upper = {68, 20, 20};  // 5 nodes in radius
  EXPECT_THROW(warnings(text, mesh), Error);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace rouleau
