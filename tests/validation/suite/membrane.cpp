// SPDX-License-Identifier: BSD-3-Clause
// The membrane by itself: energies and their convergence, forces as gradients, the shape's own digits.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <numbers>

#include "case_file.hpp"
#include "cases.hpp"
#include "membrane/measures.hpp"
#include "membrane/membrane_forces.hpp"
#include "membrane/moduli_conventions.hpp"
#include "membrane/shape_equations.hpp"
#include "membrane/transform.hpp"
#include "membrane/volume.hpp"
#include "unit/membrane/sample_cells.hpp"

namespace rouleau::validation {
namespace {

using test::one_cell;

constexpr Moduli bending_alone{.kappa_S = 0, .kappa_A = 0, .kappa_B = 1};
constexpr Moduli skalak_alone{.kappa_S = 1, .kappa_A = 100, .kappa_B = 0};

constexpr const char* independent = "computed by another program, in double precision";
constexpr const char* continuum = "analytic: integral over the smooth surface";
constexpr const char* same_mesh = "the same sum over the same mesh, by another program";
constexpr const char* gradient = "central differences of the energy";

double bending_energy(const Surface& surface) {
  const Cells cells = one_cell(surface);
  return MembraneForces(cells).energy(cells, bending_alone).bending;
}

/// A quantity on three meshes, each with half the edges of the one before, and on the smooth surface.
struct Refinement {
  std::string name;
  std::array<double, 3> ours, known;
  double digit;  ///< half a unit of the last digit that is known
  double smooth;
};

void check_refinement(Suite& suite, const Refinement& r) {
  for (std::size_t i = 0; i < 3; ++i)
    suite.check(fmt::format("{}, {} triangles", r.name, 1280 << (2 * i)), r.ours[i], near(r.known[i], r.digit),
                same_mesh);
  for (std::size_t i = 1; i < 3; ++i)
    suite.check(fmt::format("{}: order of convergence to {} triangles", r.name, 1280 << (2 * i)),
                std::log2((r.ours[i - 1] - r.smooth) / (r.ours[i] - r.smooth)), between(1.9, 2.1),
                "flat triangles on a smooth surface: second order");
  // The second-order error taken out: what is left is of fourth order.
  suite.check(r.name + ", extrapolated from the two finest meshes", (4 * r.ours[2] - r.ours[1]) / 3,
              near_relative(r.smooth, 1e-4), continuum);
}

/// A surface on the three meshes.
template <class Make, class Measure>
std::array<double, 3> on_three_meshes(const Make& make, const Measure& measure) {
  return {measure(make(3)), measure(make(4)), measure(make(5))};
}

void check_energies(Suite& suite, double radius_um) {
  const auto ball = [](int n) { return sphere(n, 1); };
  const auto blood = [&](int n) { return red_blood_cell(n, radius_um); };
  const auto relative = [](const Surface& s) { return bending_energy(s) / (8 * std::numbers::pi); };
  check_refinement(suite, {"bending energy of the sphere / (8 pi kappa_B)",
                           on_three_meshes(ball, relative),
                           {0.995259, 0.998809, 0.999701},
                           1e-6,
                           1});
  check_refinement(suite, {"bending energy of the red blood cell / kappa_B",
                           on_three_meshes(blood, bending_energy),
                           {47.4518, 48.2121, 48.4107},
                           6e-5,
                           48.4778});
}

void check_shape(Suite& suite, double radius_um) {
  const double scale = radius_um / 4;  // the digits below belong to R = 4 um
  const double to_um2 = scale * scale, to_um3 = to_um2 * scale;
  const auto blood = [&](int n) { return red_blood_cell(n, radius_um); };
  const auto volume_of = [](const Surface& s) { return volume(s); };
  const auto area_of = [](const Surface& s) { return area(s); };
  check_refinement(suite, {"volume of the red blood cell, um^3",
                           on_three_meshes(blood, volume_of),
                           {99.7972 * to_um3, 100.4471 * to_um3, 100.6105 * to_um3},
                           6e-5 * to_um3,
                           100.665006 * to_um3});
  check_refinement(suite, {"area of the red blood cell, um^2",
                           on_three_meshes(blood, area_of),
                           {139.4232 * to_um2, 140.0807 * to_um2, 140.2461 * to_um2},
                           6e-5 * to_um2,
                           140.301333 * to_um2});
  double thickest = 0, at_r = 0;
  for (double r = 0; r <= 1; r += 1e-5) {
    const double thickness = red_blood_cell_profile(r * r) * std::sqrt(1 - r * r);
    if (thickness <= thickest) continue;
    thickest = thickness;
    at_r = r;
  }
  suite.check("largest thickness, um", radius_um * thickest, near(2.622585 * scale, 1e-6), independent);
  suite.check("at the radius, um", radius_um * at_r, near(2.801 * scale, 1e-3), independent);
  suite.check("thickness at the centre, um", radius_um * red_blood_cell_profile(0), near(0.828 * scale, 1e-6),
              independent);
  const Cells rest = one_cell(blood(4));
  suite.check("asphericity at rest, 5120 triangles", asphericity(gyration_tensor(rest.X, rest.ranges[0])),
              near(0.15137, 1e-5), independent, "Eq. 19 with the square that its print lost");
}

/// A square of two sheets in the plane z = 0: every triangle sees the same stretch.
Surface flat_square(double length_x, double length_y) {
  Surface surface;
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {length_x, 0.0}, {length_x, length_y}, {0.0, length_y}}) {
    surface.X.x.push_back(x);
    surface.X.y.push_back(y);
    surface.X.z.push_back(0);
  }
  for (const Int3& t : {Int3{0, 1, 2}, Int3{0, 2, 3}, Int3{0, 2, 1}, Int3{0, 3, 2}}) {
    surface.triangles.a.push_back(t[0]);
    surface.triangles.b.push_back(t[1]);
    surface.triangles.c.push_back(t[2]);
  }
  return surface;
}

/// Energy per area at rest of a sheet stretched homogeneously.
double energy_density(double stretch_x, double stretch_y, const Moduli& moduli) {
  const Cells cells = one_cell(flat_square(stretch_x, stretch_y), flat_square(1, 1));
  return MembraneForces(cells).energy(cells, moduli).in_plane / 2;
}

void check_point_values(Suite& suite) {
  const double kappa_S = to_kappa_S(ShearConvention::B, 2.0 / 3);
  suite.check("Skalak W at stretches 1.1 and 0.95, kappa_S = 1, C = 100",
              energy_density(1.1, 0.95, {.kappa_S = 1, .kappa_A = 100, .kappa_B = 0}), near(0.0750388594, 1e-10),
              independent);
  suite.check("the same by the paper's Eq. 8, B = 2/3, C = 200/3",
              energy_density(1.1, 0.95, {.kappa_S = kappa_S, .kappa_A = 100 * kappa_S, .kappa_B = 0}),
              near(0.0750388594, 1e-10), independent);
  suite.check("Skalak W at stretches 1.1 and 0.95, kappa_S = C = 1",
              energy_density(1.1, 0.95, {.kappa_S = 1, .kappa_A = 1, .kappa_B = 0}), near(0.0051729042, 1e-10),
              independent);
  constexpr double e = 1e-4;  // the third order in e is 1e-4 of the second
  suite.check("shear modulus at small strain / kappa_S", energy_density(1 + e, 1 - e, skalak_alone) / (2 * e * e),
              near_relative(1.0 / 3, 1e-3), "W to second order");
  suite.check("area modulus at small strain / kappa_S, C = 100",
              energy_density(1 + e, 1 + e, skalak_alone) / (2 * e * e), near_relative(201.0 / 3, 1e-3),
              "W to second order");
}

void check_gradients(Suite& suite, double radius_um, double roughness) {
  const Surface rest = red_blood_cell(3, radius_um);
  Cells cells = one_cell(test::strongly_deformed(rest, roughness), rest);
  MembraneForces forces(cells);
  const double h = 1e-3 * radius_um / 4;
  const auto error_of = [&](const Moduli& moduli) {
    forces.compute(cells, moduli);
    const VectorArray force = cells.F;
    const auto energy = [&] {
      const MembraneEnergy E = forces.energy(cells, moduli);
      return E.in_plane + E.bending;
    };
    return test::relative_difference(test::numerical_force(cells, h, energy), force);
  };
  suite.check("bending force against the gradient, relative", error_of(bending_alone), at_most(1e-7), gradient);
  suite.check("Skalak force against the gradient, relative", error_of(skalak_alone), at_most(1e-8), gradient);

  for (const auto& [name, moduli] : {std::pair{"bending", bending_alone}, {"Skalak", skalak_alone}}) {
    forces.compute(cells, moduli);
    Vec3 torque = Vec3::Zero();
    double size = 0;
    for (std::size_t v = 0; v < cells.vertices(); ++v) {
      torque += at(cells.X, v).cross(at(cells.F, v));
      size += at(cells.F, v).norm();
    }
    suite.check(fmt::format("{}: sum of the forces / sum of their sizes", name), test::total(cells.F).norm() / size,
                at_most(1e-12), "no force from outside");
    suite.check(fmt::format("{}: sum of the torques / (R times the sizes)", name), torque.norm() / (radius_um * size),
                at_most(1e-12), "no torque from outside");
  }
}

/// Largest difference of the forces on a turned and moved cell from the turned forces, over the largest force.
double turned_force_error(const Surface& shape, const Surface& rest, const Moduli& moduli) {
  Cells cells = one_cell(shape, rest);
  MembraneForces(cells).compute(cells, moduli);
  const Vec3 axis = Vec3(1, -2, 0.5).normalized();
  Surface moved = shape;
  rotate(moved, axis, 1.1);
  translate(moved, {6, 1.8, -1.5});
  Cells moved_cells = one_cell(moved, rest);
  MembraneForces(moved_cells).compute(moved_cells, moduli);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, axis).toRotationMatrix();
  double largest = 0, error = 0;
  for (std::size_t v = 0; v < cells.vertices(); ++v) {
    largest = std::max(largest, at(cells.F, v).norm());
    error = std::max(error, (at(moved_cells.F, v) - turn * at(cells.F, v)).norm());
  }
  return error / largest;
}

void check_motion_and_volume(Suite& suite, double radius_um) {
  const Surface rest = red_blood_cell(4, radius_um);
  Cells cells = one_cell(rest);
  MembraneForces(cells).compute(cells, skalak_alone);
  suite.check("Skalak force on the undeformed mesh", test::norm(cells.F), at_most(0), "exactly zero");
  const Surface deformed = test::strongly_deformed(rest, 0.005);
  suite.check("Skalak forces turn with the cell, relative", turned_force_error(deformed, rest, skalak_alone),
              at_most(1e-9), "invariance");
  suite.check("bending forces turn with the cell, relative", turned_force_error(deformed, rest, bending_alone),
              at_most(1e-9), "invariance");

  Surface swollen = rest;
  scale(swollen, 1.01);
  Cells leaking = one_cell(swollen, rest);
  VolumeShift(leaking).restore(leaking);
  suite.check("volume error after the volume shift, 3 % before", volume(leaking, 0) / volume(rest) - 1, at_most(1e-12),
              "its promise");
}

}  // namespace

void membrane(Suite& suite) {
  CaseFile file(suite.places().studies / "membrane.ini");
  const double radius_um = file.number("cell", "radius_um"), roughness = file.number("cell", "roughness");
  file.require_all_used();
  check_energies(suite, radius_um);
  check_shape(suite, radius_um);
  check_point_values(suite);
  check_gradients(suite, radius_um, roughness);
  check_motion_and_volume(suite, radius_um);
}

}  // namespace rouleau::validation
