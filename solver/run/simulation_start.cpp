// SPDX-License-Identifier: BSD-3-Clause
// The state that a run starts from.
#include "fluid/initial.hpp"
#include "interior/analytic.hpp"
#include "interior/ray_cast.hpp"
#include "run/coupled_simulation.hpp"

namespace rouleau {

template <class Real>
void CoupledSimulation<Real>::start() {
  start_fluid();
  exchange_populations();
  start_flags();
}

template <class Real>
void CoupledSimulation<Real>::start_fluid() {
  const LatticeParameters& p = setup_.lattice;
  const FlowParameters& flow = setup_.run.parameters.flow;
  const double initial_mean = flow.initial == InitialFlow::developed ? p.mean_velocity : p.initial_velocity;
  driving_.force = p.body_force;
  if (controller_) driving_ = controller_->start(initial_mean);

  const Vec3 force(driving_.force, 0, 0);
  switch (flow.initial) {
    case InitialFlow::rest:
      set_uniform(fluid_, Vec3::Zero(), force);
      break;
    case InitialFlow::uniform:
      set_uniform(fluid_, Vec3(p.initial_velocity, 0, 0), force);
      break;
    case InitialFlow::developed:
      if (flow.driving == Driving::shear)
        set_sheared(fluid_, 2, force);
      else
        set_developed(fluid_, p.max_velocity / p.max_to_mean, force);
      break;
  }
}

template <class Real>
void CoupledSimulation<Real>::start_flags() {
  if (!tracker_) return;
  if (setup_.cells.bodies.empty())
    cast_rays(cells_, fluid_.lattice, fluid_.block, RaySearch::columns, flags_);
  else
    flag_bodies(setup_.cells.bodies, fluid_.lattice, fluid_.block, flags_);
}

template void CoupledSimulation<float>::start();
template void CoupledSimulation<double>::start();
template void CoupledSimulation<float>::start_fluid();
template void CoupledSimulation<double>::start_fluid();
template void CoupledSimulation<float>::start_flags();
template void CoupledSimulation<double>::start_flags();

}  // namespace rouleau
