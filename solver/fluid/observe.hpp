// SPDX-License-Identifier: BSD-3-Clause
// Density and velocity of the flow between two steps, node by node: what the next step will find there.
#pragma once

#include "fluid/equilibrium.hpp"
#include "fluid/fluid.hpp"

namespace rouleau {

/// Lattice units.
struct NodeFlow {
  double rho_1 = 0;  ///< rho - 1
  Vec3 u = Vec3::Zero();
};

/// The moments of the populations that will stream to an owned node (local coordinates), with half of the force that
/// will act there: the velocity that belongs to the present positions of the membranes. It follows from the state
/// alone, unlike fluid.u, which is one step old and set near membranes only.   [Guo2002] eq. 19
/// reads   fluid.f with its halos and walls filled, fluid.g
template <class Real>
NodeFlow flow_at(const Fluid<Real>& fluid, const Vec3& body_force, const Int3& node) {
  const auto streaming_in = [&](int q) {
    const int x = node[0] - c_q[q][0];
    return fluid.f.at(q, fluid.closes_x() ? fluid.lattice.wrap(0, x) : x, node[1] - c_q[q][1], node[2] - c_q[q][2]);
  };
  Pulled<Real> f;
  f.rest = streaming_in(0);
  for (int p = 0; p < pairs; ++p) {
    const Real plus = streaming_in(1 + 2 * p), minus = streaming_in(2 + 2 * p);
    f.sum[p] = plus + minus;
    f.difference[p] = plus - minus;
  }
  Real3<Real> F;
  for (std::size_t a = 0; a < 3; ++a)
    F[a] = Real(body_force[static_cast<Eigen::Index>(a)]) + fluid.g[a](node[0], node[1], node[2]);
  const Moments<Real> m = moments(f, F);
  return {m.rho_1, Vec3(m.u[0], m.u[1], m.u[2])};
}

}  // namespace rouleau
