// SPDX-License-Identifier: BSD-3-Clause
// From the user's units to the lattice's, against the numbers of the paper's channel worked out by hand.
#include "run/lattice_parameters.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/run/run_text.hpp"

namespace rouleau {
namespace {

using test::Read;
using test::RunText;

// The reference numbers are given to the digits written.
void expect_digits(double value, double reference, double relative) {
  EXPECT_NEAR(value, reference, relative * std::abs(reference));
}

TEST(LatticeParameters, HaveThePapersNumbers) {
  const Read r{RunText{}};
  EXPECT_EQ(r.lattice.lattice.size, (Int3{128, 36, 30}));
  EXPECT_EQ(r.lattice.lattice.periodic, (std::array{true, false, false}));
  EXPECT_EQ(r.lattice.tau_out, 1.0);
  EXPECT_NEAR(r.lattice.tau_in, 3.0, 1e-15);
  expect_digits(r.lattice.mean_velocity, 6.944e-4, 1e-4);
  expect_digits(r.lattice.max_velocity, 1.450e-3, 5e-4);
  expect_digits(r.lattice.body_force, 3.0966e-6, 2e-5);
  expect_digits(r.lattice.moduli.kappa_S, 3.215e-4, 2e-4);
  expect_digits(r.lattice.moduli.kappa_A, 0.03215, 2e-4);
  expect_digits(r.lattice.moduli.kappa_B, 1.736e-4, 3e-4);
  EXPECT_EQ(r.lattice.steps, 60000260);  // 9.2593 s / 0.154321 us = 60000259.2
}

TEST(LatticeParameters, HaveThePapersDimensionlessNumbers) {
  const DimensionlessNumbers n = Read(RunText{}).numbers();
  expect_digits(n.inflation, 10, 1e-5);
  expect_digits(n.mach, 0.0025, 0.01);
  expect_digits(n.reynolds_channel, 0.0136, 3e-3);
  expect_digits(n.reynolds_cell, 0.0104, 5e-3);
  expect_digits(n.capillary_flow, 0.75, 5e-3);
  expect_digits(n.area_number, 0.193, 1e-3);
  expect_digits(n.bending_number, 1.04e-3, 2e-3);
}

TEST(LatticeParameters, DriveTheDuctByItsSeries) {
  const Read r{RunText{}};
  expect_digits(r.lattice.max_to_mean, 2.088638, 3e-7);
  expect_digits(r.units.pressure_gradient_Pa_per_m(r.lattice.body_force), 4.33424e5, 2e-6);
  expect_digits(r.units.speed_mm_per_s(r.lattice.max_velocity), 3.13296, 2e-6);
  // u_mean = 0.04152973 G H^2 / mu
  expect_digits(1.5e-3 * 1.2e-3 / (4.33424e5 * 10e-6 * 10e-6), 0.04152973, 2e-6);
}

TEST(LatticeParameters, AgreeBetweenHeldVelocityAndItsPressureGradient) {
  const Read held{RunText{}};
  const Read fixed{RunText{.flow = "driving = pressure_gradient\npressure_gradient_Pa_per_m = 4.33424e5"}};
  EXPECT_EQ(fixed.lattice.mean_velocity, 0);
  expect_digits(fixed.lattice.body_force, held.lattice.body_force, 2e-6);  // digits of the gradient
  expect_digits(fixed.lattice.max_velocity, held.lattice.max_velocity, 2e-6);
}

TEST(LatticeParameters, UseThePlaneChannelIfOneAxisIsPeriodic) {
  const Read r{RunText{.channel = "boundary_y = periodic"}};
  EXPECT_NEAR(r.lattice.max_to_mean, 1.5, 1e-14);
  const double H = 30;  // nodes between the z walls: u_mean = G H^2 / (12 nu)
  expect_digits(r.lattice.body_force, 12 * r.lattice.nu_out * r.lattice.mean_velocity / (H * H), 1e-14);
}

TEST(LatticeParameters, MoveTheWallsForShear) {
  const Read r{RunText{.channel = "boundary_y = periodic", .flow = "driving = shear\nshear_rate_per_s = 600"}};
  // +-600/s x 10 um / 2 = 3 mm/s
  expect_digits(r.units.speed_mm_per_s(r.lattice.wall_velocity), 3, 1e-14);
  EXPECT_EQ(r.lattice.body_force, 0);
  EXPECT_EQ(r.lattice.max_velocity, r.lattice.wall_velocity);
}

TEST(LatticeParameters, GiveBothFluidsTheSameBitsAtLambdaOne) {
  for (const char* tau : {"1", "0.77", "0.51", "2.2", "1.0000001"}) {
    const Read r{RunText{.fluid = "lambda = 1", .numerics = std::string("tau_plasma = ") + tau}};
    EXPECT_EQ(r.lattice.nu_in, r.lattice.nu_out);
    EXPECT_EQ(r.lattice.tau_in, r.lattice.tau_out);
  }
}

TEST(LatticeParameters, TakeTheModulusInThreeConventions) {
  const double kappa_S = Read(RunText{.membrane = "shear_modulus_uN_per_m = 6"}).lattice.moduli.kappa_S;
  const auto in = [](const std::string& modulus, const std::string& convention) {
    return Read(RunText{.membrane =
                            "shear_modulus_uN_per_m = " + modulus + "\nshear_modulus_convention = " + convention})
        .lattice.moduli;
  };
  EXPECT_NEAR(in("2", "G_s").kappa_S, kappa_S, 1e-15 * kappa_S);
  EXPECT_NEAR(in("4", "B").kappa_S, kappa_S, 1e-15 * kappa_S);
  EXPECT_NEAR(in("4", "B").kappa_A, 100 * kappa_S, 1e-13 * kappa_S);  // C is the same number in all three
}

TEST(LatticeParameters, LeaveTheNeoHookeanMembraneWithoutAnAreaModulus) {
  const Moduli moduli = Read(RunText{.membrane = "law = neo_hookean\nshear_modulus_uN_per_m = 6"}).lattice.moduli;
  EXPECT_EQ(moduli.law, InPlaneLaw::neo_hookean);
  EXPECT_EQ(moduli.kappa_A, 0);
  EXPECT_EQ(moduli.kappa_S, Read(RunText{.membrane = "shear_modulus_uN_per_m = 6"}).lattice.moduli.kappa_S);
}

TEST(LatticeParameters, RaiseTheStretchingForceSmoothly) {
  EXPECT_FALSE(Read(RunText{}).lattice.stretch.axis);
  const auto stretch = [](const std::string& ramp) {
    return Read(RunText{.more = "[stretch]\naxis = y\nforce_pN = 100\n" + ramp}).lattice.stretch;
  };
  const Units units(Read(RunText{}).run.parameters);
  const StretchForce ramped = stretch("ramp_ms = 1.54321");  // 10000 steps
  EXPECT_EQ(ramped.axis, 1u);
  EXPECT_DOUBLE_EQ(units.force_pN(ramped.force), 100);
  // kappa_S = 5 uN/m over one spacing of 1/3 um is 5/3 pN.
  const double kappa_S = Read(RunText{.membrane = "shear_modulus_uN_per_m = 5"}).lattice.moduli.kappa_S;
  expect_digits(ramped.force, 60 * kappa_S, 1e-14);
  EXPECT_EQ(ramped.in_step_after(0), 0);
  expect_digits(ramped.in_step_after(5000), 0.5 * ramped.force, 1e-12);
  EXPECT_EQ(ramped.in_step_after(10000), ramped.force);
  EXPECT_EQ(ramped.in_step_after(1000000), ramped.force);
  EXPECT_EQ(stretch("").in_step_after(0), ramped.force);  // at once
}

TEST(LatticeParameters, PlaceTheCellByItsOffsetFromTheAxis) {
  const Read r{RunText{.cell = "offset_y_um = 1.5\noffset_z_um = 5/6"}};
  const CellPlacement& cell = r.lattice.cells[0];
  EXPECT_NEAR(cell.centre[0], 63.5, 1e-12);
  EXPECT_NEAR(cell.centre[1], 17.5 + 4.5, 1e-12);
  EXPECT_NEAR(cell.centre[2], 14.5 + 2.5, 1e-12);
  EXPECT_NEAR(cell.radius, 12, 1e-12);
  EXPECT_NEAR(cell.from_um, 3, 1e-15);
}

TEST(LatticeParameters, BoundTheTurnedCell) {
  // Thickest 2.622585 um at R = 4 um; the sampled maximum is good to 1e-6.
  const Vec3 flat = Read(RunText{}).lattice.cells[0].half_extent / 3;
  EXPECT_NEAR(flat[0], 4, 1e-6);
  EXPECT_NEAR(flat[1], 4, 1e-6);
  EXPECT_NEAR(flat[2], 2.622585 / 2, 2e-6);
  const Vec3 upright = Read(RunText{.cell = "rotation_angle_deg = 90"}).lattice.cells[0].half_extent / 3;
  EXPECT_NEAR(upright[0], 2.622585 / 2, 2e-6);
  EXPECT_NEAR(upright[2], 4, 1e-6);
  // An ellipsoid turned by 45 degrees about z: sqrt((a^2 + b^2) / 2).
  const Vec3 oblique =
      Read(RunText{.cell = "shape = ellipsoid\nsemi_axes_um = 4 2 3\nrotation_axis = 0 0 2\nrotation_angle_deg = 45"})
          .lattice.cells[0]
          .half_extent /
      3;
  EXPECT_NEAR(oblique[0], std::sqrt(10.0), 1e-12);
  EXPECT_NEAR(oblique[1], std::sqrt(10.0), 1e-12);
  EXPECT_NEAR(oblique[2], 3, 1e-12);
}

TEST(LatticeParameters, DisplaceReplicasWithinTheJitterAndRepeatably) {
  const Vec3 origin = Read(RunText{}).lattice.cells[0].centre;
  Vec3 mean = Vec3::Zero(), previous = origin;
  constexpr int replicas = 200;
  for (int n = 1; n <= replicas; ++n) {
    const RunText text{.cell = "jitter_um = 0.1\nreplica = " + std::to_string(n)};
    const Vec3 centre = Read(text).lattice.cells[0].centre;
    EXPECT_EQ(centre, Read(text).lattice.cells[0].centre);
    const Vec3 shift = (centre - origin) / 0.3;  // in units of the jitter
    EXPECT_LE(shift.cwiseAbs().maxCoeff(), 1.0 + 1e-12);
    EXPECT_NE(centre, previous);
    mean += shift / replicas;
    previous = centre;
  }
  // Uniform in [-1, 1]: the mean of 200 has a standard deviation of 0.041; five of them.
  EXPECT_LT(mean.cwiseAbs().maxCoeff(), 0.2);
}

TEST(Units, ReturnWhatTheyConverted) {
  const Units u(Read(RunText{}).run.parameters);
  const double rounding = 1e-14;
  expect_digits(u.length_um(u.length(7.3)), 7.3, rounding);
  expect_digits(u.coordinate_um(u.coordinate(7.3)), 7.3, rounding);
  expect_digits(u.speed_mm_per_s(u.speed(1.5)), 1.5, rounding);
  expect_digits(u.rate_per_s(u.rate(600)), 600, rounding);
  expect_digits(u.tension_uN_per_m(u.tension(5)), 5, rounding);
  expect_digits(u.energy_joule(u.energy(3e-19)), 3e-19, rounding);
  expect_digits(u.pressure_gradient_Pa_per_m(u.force_density(4e5)), 4e5, rounding);
  EXPECT_EQ(u.coordinate(0), -0.5);  // the lower face
}

// Identities of units: a pressure of 1 that falls to 0 over a node spacing is a force density of 1, which acts on a
// node with a force of 1, as does a tension of 1 along an edge of 1.
TEST(Units, OfPicturesBelongToEachOther) {
  const Units u(Read(RunText{}).run.parameters);
  const double rounding = 1e-14, dx_m = u.dx_um() * 1e-6;
  expect_digits(u.pressure_Pa(1) / dx_m, u.pressure_gradient_Pa_per_m(1), rounding);
  expect_digits(u.force_density_pN_per_um3(1) * std::pow(u.dx_um(), 3), u.force_pN(1), rounding);
  expect_digits(u.tension_uN_per_m(1) * u.dx_um(), u.force_pN(1), rounding);
  expect_digits(u.force_pN(u.force(20)), 20, rounding);
  expect_digits(u.curvature_per_um(1 / u.length(4)), 0.25, rounding);
}

TEST(Units, CountTheStepThatReachesTheEnd) {
  const Units u(Read(RunText{.spacing = "node_spacing_um = 1/3\ntime_step_us = 0.5"}).run.parameters);
  EXPECT_EQ(u.steps(1.0), 2000000);
  EXPECT_EQ(u.steps(1.0000001), 2000001);
  EXPECT_EQ(u.steps(0.3), 600000);  // 0.3 / 5e-7 is not whole in binary
  EXPECT_DOUBLE_EQ(u.time_s(600000), 0.3);
}

}  // namespace
}  // namespace rouleau
