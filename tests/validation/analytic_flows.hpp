// SPDX-License-Identifier: BSD-3-Clause
// Steady flows of known solution, each run to its steady state and compared: what tests and suite ask of the fluid.
#pragma once

#include <algorithm>
#include <cmath>

#include "fluid/developed.hpp"
#include "fluid/initial.hpp"
#include "support/one_block.hpp"

namespace rouleau::testing {

/// Force-driven flow between two plates: errors over the profile, in units of the largest velocity.
struct ProfileError {
  double largest = 0, mean = 0;
};

/// N nodes between walls of `axis`; the velocity's unit is u_max, in lattice units.
template <class Real>
ProfileError plane_channel_error(const Collision& collision, double nu, int axis, int N, double u_max = 1e-3) {
  Lattice lattice{{3, 2, 2}, {true, true, true}};
  lattice.size[axis] = N;
  lattice.periodic[axis] = false;
  OneBlock<Real> block(lattice, collision);
  const double G = 8 * nu * u_max / (N * N);
  block.body_force = Vec3(G, 0, 0);
  set_uniform(block.fluid, Vec3::Zero(), block.body_force);
  block.run(static_cast<int>(40 * N * N / (9.87 * nu)) + 1000);  // 40 times the slowest decay: below 1e-16
  ProfileError error;
  for (int n = 0; n < N; ++n) {
    const double y = (n + 0.5) / N;
    Int3 node{1, 1, 1};
    node[axis] = n;
    const double e = block.u(0, node[0], node[1], node[2]) / u_max - 4 * y * (1 - y);
    error.largest = std::max(error.largest, std::abs(e));
    error.mean += e / N;
  }
  return error;
}

/// What the wall rule adds to every node of that flow, in units of u_max.   [Ginzburg 2008]
inline double plane_channel_slip(double magic, int N) { return (16 * magic - 3) / (3.0 * N * N); }

/// Force-driven flow through a rectangular channel.
struct DuctError {
  double l2 = 0;       ///< relative to the exact field at the nodes
  double mean = 0;     ///< mean over the nodes against the true mean of the cross-section
  double largest = 0;  ///< velocity of the fastest node against the exact one there
};

template <class Real>
DuctError duct_error(const Collision& collision, double nu, int ny, int nz, int steps) {
  const Lattice lattice{{1, ny, nz}, {true, false, false}};
  OneBlock<Real> block(lattice, collision);
  const DevelopedFlow flow(lattice);
  const double target = 7e-4, scale = target / flow.mean();
  block.body_force = Vec3(scale * nu, 0, 0);
  set_developed(block.fluid, target, block.body_force);
  block.run(steps);
  DuctError error;
  double difference = 0, square = 0, sum = 0;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j) {
      const double exact = scale * flow.velocity(j - (ny - 1) / 2.0, k - (nz - 1) / 2.0), u = block.u(0, 0, j, k);
      difference += (u - exact) * (u - exact);
      square += exact * exact;
      sum += u;
    }
  error.l2 = std::sqrt(difference / square);
  error.mean = sum / (ny * nz) / target - 1;
  const int y = ny / 2, z = nz / 2;
  error.largest = block.u(0, 0, y, z) / (scale * flow.velocity(y - (ny - 1) / 2.0, z - (nz - 1) / 2.0)) - 1;
  return error;
}

/// Two fluids of viscosity nu_1 and lambda nu_1 between plates at -h and h, h = N/2 nodes.
struct TwoFluidFlow {
  double lambda = 5, nu_1 = 1.0 / 6;
  int N = 20;
  double shift = 0;  ///< of the true interface above the flags' staircase, node spacings: where it cuts the link
};

/// The lower wall at rest, the upper one sliding with U, the thick fluid below: largest error in units of U.
template <class Real>
double two_layer_couette_error(const Collision& collision, const TwoFluidFlow& flow) {
  constexpr double U = 1e-3;
  const int N = flow.N;
  OneBlock<Real> block({{3, 2, N}, {true, true, false}}, collision);
  block.fluid.wall_velocity[2][1] = Vec3(U, 0, 0);
  for (int k = 0; k < N / 2; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 3; ++i) block.inside(i, j, k) = 1;
  block.run(60 * N * N);
  const double z_i = 0.5 + flow.shift / N;  // stress is continuous: slopes 1 : lambda
  const double u_i = U * z_i / (z_i + flow.lambda * (1 - z_i));
  double largest = 0;
  for (int k = 0; k < N; ++k) {
    const double z = (k + 0.5) / N;
    const double exact = z < z_i ? u_i * z / z_i : u_i + (U - u_i) * (z - z_i) / (1 - z_i);
    largest = std::max(largest, std::abs(block.u(0, 1, 1, k) - exact) / U);
  }
  return largest;
}

/// Velocity in units of G h^2 / nu_1 at y in units of h: nu_1 below, lambda nu_1 above y = 0.
/// u_j = G h^2/(2 mu_j) [2 mu_j/(mu_1 + mu_2) + (mu_1 - mu_2)/(mu_1 + mu_2) y/h - (y/h)^2]
inline double two_layers(double y, double lambda) {
  const double nu_j = y < 0 ? 1 : lambda;
  return (2 * nu_j / (1 + lambda) + (1 - lambda) / (1 + lambda) * y - y * y) / (2 * nu_j);
}

/// The same for a core |y| < h/2 of viscosity lambda nu_1 in a sheath of nu_1.
inline double core_and_sheath(double y, double lambda) {
  const double a = std::abs(y);
  return a > 0.5 ? (1 - a * a) / 2 : 0.375 + (0.25 - a * a) / (2 * lambda);
}

/// Force-driven: error relative to the exact profile, root of the sum of squares over the nodes.
/// `exact(y, lambda)` as above; `is_thick(y)` where the fluid of viscosity lambda nu_1 is.
template <class Real>
double two_fluid_poiseuille_error(const Collision& collision, const TwoFluidFlow& flow, double (*exact)(double, double),
                                  bool (*is_thick)(double)) {
  constexpr double unit = 1e-3;  // G h^2 / nu_1
  const int N = flow.N;
  const double h = N / 2.0;
  OneBlock<Real> block({{3, 2, N}, {true, true, false}}, collision);
  block.body_force = Vec3(unit * flow.nu_1 / (h * h), 0, 0);
  set_uniform(block.fluid, Vec3::Zero(), block.body_force);
  const auto y_of = [&](int k) { return (k + 0.5 - h) / h; };
  for (int k = 0; k < N; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 3; ++i) block.inside(i, j, k) = is_thick(y_of(k)) ? 1 : 0;
  block.run(40 * N * N);
  double difference = 0, square = 0;
  for (int k = 0; k < N; ++k) {
    const double e = exact(y_of(k), flow.lambda);
    difference += std::pow(block.u(0, 1, 1, k) / unit - e, 2);
    square += e * e;
  }
  return std::sqrt(difference / square);
}

template <class Real>
double two_layer_poiseuille_error(const Collision& collision, const TwoFluidFlow& flow) {
  return two_fluid_poiseuille_error<Real>(collision, flow, two_layers, [](double y) { return y > 0; });
}

}  // namespace rouleau::testing
