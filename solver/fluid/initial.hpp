// SPDX-License-Identifier: BSD-3-Clause
// The flow that a run starts from.
#pragma once

#include <functional>

#include "fluid/fluid.hpp"

namespace rouleau {

/// Density 1 and the velocity `u_of(global node)`, in equilibrium under `body_force`: f = f_eq + S_F/2, what a
/// collision leaves of a node in equilibrium, so that the momentum sum c f - F/2 of the state is u. Nothing of the
/// shear stress is preset: it builds up in a few steps. sets fluid.f and fluid.u of owned nodes; halos are to be filled
/// by the caller
template <class Real>
void set_equilibrium(Fluid<Real>& fluid, const std::function<Vec3(const Int3&)>& u_of, const Vec3& body_force);

/// The same velocity everywhere; zero for a fluid at rest.
template <class Real>
void set_uniform(Fluid<Real>& fluid, const Vec3& u, const Vec3& body_force);

/// The developed channel flow along x, scaled so that the mean over the nodes of the lattice is `mean_velocity`.
/// throws Error(bad_input) if neither y nor z has walls
template <class Real>
void set_developed(Fluid<Real>& fluid, double mean_velocity, const Vec3& body_force);

/// Linear between the velocities of the two walls of an axis (Couette flow).
/// throws Error(bad_input) if the axis is periodic
template <class Real>
void set_sheared(Fluid<Real>& fluid, int axis, const Vec3& body_force);

extern template void set_equilibrium(Fluid<float>&, const std::function<Vec3(const Int3&)>&, const Vec3&);
extern template void set_equilibrium(Fluid<double>&, const std::function<Vec3(const Int3&)>&, const Vec3&);
extern template void set_uniform(Fluid<float>&, const Vec3&, const Vec3&);
extern template void set_uniform(Fluid<double>&, const Vec3&, const Vec3&);
extern template void set_developed(Fluid<float>&, double, const Vec3&);
extern template void set_developed(Fluid<double>&, double, const Vec3&);
extern template void set_sheared(Fluid<float>&, int, const Vec3&);
extern template void set_sheared(Fluid<double>&, int, const Vec3&);

}  // namespace rouleau
