// SPDX-License-Identifier: BSD-3-Clause
// Initial states of the fluid.
#include "fluid/initial.hpp"

#include <vector>

#include "base/error.hpp"
#include "fluid/developed.hpp"
#include "fluid/equilibrium.hpp"

namespace rouleau {

namespace {

/// f_eq + S_F/2 of density 1. In double whatever the precision of the populations: rounded once.
std::array<double, Q> equilibrium_after_collision(const Vec3& u, const Vec3& F) {
  Moments<double> m;
  m.rho_1 = 0;
  m.F = {F[0], F[1], F[2]};
  m.j = {u[0], u[1], u[2]};
  m.u = m.j;
  m.even_0 = -1.5 * dot(m.u, m.j);
  m.u_F = dot(m.u, m.F);
  std::array<double, Q> f;
  f[0] = equilibrium_rest(m) + 0.5 * guo_source_rest(m);
  unrolled<pairs>([&](auto p) {
    const Pair<double> eq = equilibrium<p>(m), source = guo_source<p>(m);
    const double even = eq.even + 0.5 * source.even, odd = eq.odd + 0.5 * source.odd;
    f[1 + 2 * p] = even + odd;
    f[2 + 2 * p] = even - odd;
  });
  return f;
}

}  // namespace

template <class Real>
void set_equilibrium(Fluid<Real>& fluid, const std::function<Vec3(const Int3&)>& u_of, const Vec3& body_force) {
  const Block& block = fluid.block;
  for (int k = 0; k < block.size[2]; ++k)
    for (int j = 0; j < block.size[1]; ++j)
      for (int i = 0; i < block.size[0]; ++i) {
        const Vec3 u = u_of({block.begin[0] + i, block.begin[1] + j, block.begin[2] + k});
        const std::array<double, Q> f = equilibrium_after_collision(u, body_force);
        for (int q = 0; q < Q; ++q) fluid.f.at(q, i, j, k) = Real(f[q]);
        for (int a = 0; a < 3; ++a) fluid.u[a](i, j, k) = Real(u[a]);
      }
}

template <class Real>
void set_uniform(Fluid<Real>& fluid, const Vec3& u, const Vec3& body_force) {
  set_equilibrium(
      fluid, [&](const Int3&) { return u; }, body_force);
}

template <class Real>
void set_developed(Fluid<Real>& fluid, double mean_velocity, const Vec3& body_force) {
  const Lattice& lattice = fluid.lattice;
  const DevelopedFlow flow(lattice);
  const int ny = lattice.size[1], nz = lattice.size[2];
  std::vector<double> profile;  // [k][j] of the whole cross-section: the mean is the same number on every rank
  double sum = 0;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j) sum += profile.emplace_back(flow.velocity(j - (ny - 1) / 2.0, k - (nz - 1) / 2.0));
  const double scale = mean_velocity * static_cast<double>(profile.size()) / sum;
  set_equilibrium(
      fluid,
      [&](const Int3& node) { return Vec3(scale * profile[static_cast<std::size_t>(node[1] + ny * node[2])], 0, 0); },
      body_force);
}

template <class Real>
void set_sheared(Fluid<Real>& fluid, int axis, const Vec3& body_force) {
  if (fluid.lattice.periodic[axis])
    fail(Exit::bad_input, "shear flow needs walls on axis {}, which is periodic.", "xyz"[axis]);
  const Vec3& low = fluid.wall_velocity[axis][0];
  const Vec3& high = fluid.wall_velocity[axis][1];
  const int n = fluid.lattice.size[axis];
  set_equilibrium(
      fluid, [&, axis](const Int3& node) { return Vec3(low + (high - low) * ((node[axis] + 0.5) / n)); }, body_force);
}

template void set_equilibrium(Fluid<float>&, const std::function<Vec3(const Int3&)>&, const Vec3&);
template void set_equilibrium(Fluid<double>&, const std::function<Vec3(const Int3&)>&, const Vec3&);
template void set_uniform(Fluid<float>&, const Vec3&, const Vec3&);
template void set_uniform(Fluid<double>&, const Vec3&, const Vec3&);
template void set_developed(Fluid<float>&, double, const Vec3&);
template void set_developed(Fluid<double>&, double, const Vec3&);
template void set_sheared(Fluid<float>&, int, const Vec3&);
template void set_sheared(Fluid<double>&, int, const Vec3&);

}  // namespace rouleau
