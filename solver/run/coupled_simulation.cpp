// SPDX-License-Identifier: BSD-3-Clause
#include "run/coupled_simulation.hpp"

#include <algorithm>

#include "coupling/spread.hpp"
#include "fluid/flow_rate.hpp"
#include "fluid/walls.hpp"
#include "membrane/assemble.hpp"
#include "membrane/wrap.hpp"
#include "run/choices.hpp"

namespace rouleau {

template <class Real>
CoupledSimulation<Real>::CoupledSimulation(const Setup& setup, const Communicator& comm,
                                           const Decomposition& decomposition)
    : setup_(setup),
      comm_(comm),
      fluid_(setup.lattice.lattice, decomposition.block()),
      collision_(collision_of(setup)),
      flags_(decomposition.block().size, 1),
      cells_(assemble(setup.cells.starts)),
      cell_record_(cells_),
      reach_(setup.lattice.lattice, decomposition.block(), velocity_halo),
      stencils_(kernel_of(setup), setup.lattice.lattice, decomposition.block(), cells_.vertices()),
      forces_(cells_),
      fold_resistance_(cells_, setup.run.parameters.numerics.fold_resistance * setup.lattice.moduli.kappa_B),
      mesh_health_(cells_),
      volume_shift_(cells_),
      mesh_mobility_(cells_, setup.run.parameters.numerics.mesh_mobility, setup.lattice.nu_out + setup.lattice.nu_in),
      correction_(setup.lattice.lattice, decomposition.block()),
      controller_(controller_of(setup)),
      population_halo_(comm, decomposition, fluid_.f.layout, 1, 5),
      velocity_halo_(comm, decomposition, fluid_.u[0].layout, velocity_halo, 3),
      flag_halo_(comm, decomposition, flags_.layout, 1, 1),
      vertex_exchange_(comm, cells_.vertices()) {
  if (const StretchForce& pull = setup.lattice.stretch; pull.axis) stretch_.emplace(cells_, *pull.axis, pull.share);
  if (const auto variant = tracking_of(setup)) tracker_.emplace(*variant, fluid_.lattice, fluid_.block, cells_);
  walls_.u = fluid_.wall_velocity = wall_velocities_of(setup);
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) crossing_[axis][side].resize(5);
}

template <class Real>
void CoupledSimulation<Real>::step() {
  timers_.start();
  hold_mean_velocity();
  compute_membrane_forces();
  spread_forces();
  move_fluid();
  exchange_velocity();
  interpolate_velocity();
  advect_vertices();
  restore_volume();
  track_interior();
  ++counters_.steps_done;
  correct_interior();
}

template <class Real>
void CoupledSimulation<Real>::hold_mean_velocity() {
  // At the top of the step, so that between steps `driving_.force` is the force that acted in the last one.
  if (!controller_ || counters_.steps_done % controller_->interval() != 0) return;
  controller_->update(driving_, mean_velocity());
  timers_.lap(Part::control);
}

template <class Real>
void CoupledSimulation<Real>::compute_membrane_forces() {
  find_stencils(cells_, stencils_);
  timers_.lap(Part::stencils);
  sum_membrane_forces(mesh_mobility_.needs(stencils_));
  timers_.lap(Part::forces);
}

/// Sets cells_.F of the vertices in the mask; of all, if it is empty.
template <class Real>
void CoupledSimulation<Real>::sum_membrane_forces(std::span<const std::uint8_t> needed) {
  forces_.compute(cells_, setup_.lattice.moduli, needed);
  fold_resistance_.add(cells_);
  if (stretch_) stretch_->add(cells_.F, setup_.lattice.stretch.in_step_after(counters_.steps_done));
}

template <class Real>
void CoupledSimulation<Real>::spread_forces() {
  clear_touched(stencils_, fluid_.g);
  spread(cells_.F, stencils_, fluid_.g);
  timers_.lap(Part::spread);
}

template <class Real>
void CoupledSimulation<Real>::move_fluid() {
  collide_and_stream(fluid_, collision_, flags_, Vec3(driving_.force, 0, 0), {stencils_.rows, stencils_.segment_shift});
  timers_.lap(Part::collide);
  exchange_populations();
  timers_.lap(Part::halos);
}

template <class Real>
void CoupledSimulation<Real>::exchange_populations() {
  for (int axis = 0; axis < 3; ++axis) {
    std::array<std::size_t, 2> filled{};
    for (int q = 0; q < Q; ++q)
      if (c_q[q][axis] != 0) {
        const std::size_t side = c_q[q][axis] < 0 ? 0 : 1;
        crossing_[axis][side][filled[side]++] = fluid_.f.rows(q);
      }
  }
  population_halo_.exchange(crossing_, fluid_.closes_x() ? 1 : 0);
  fill_walls(fluid_);
}

template <class Real>
void CoupledSimulation<Real>::exchange_velocity() {
  std::array<Rows<Real>, 3> u;
  for (std::size_t a = 0; a < 3; ++a) u[a] = fluid_.u[a].layout.rows(fluid_.u[a].data.data());
  reach_.find(stencils_);
  if (fluid_.closes_x() && reach_.reaches_halo()) close_velocity_rows(u);
  velocity_halo_.exchange(u, fluid_.closes_x() ? 1 : 0, reach_.runs());
  timers_.lap(Part::halos);
}

/// Sets the halo along x of the rows that a stencil touches from their other end.
template <class Real>
void CoupledSimulation<Real>::close_velocity_rows(const std::array<Rows<Real>, 3>& u) {
  const Int3& size = fluid_.block.size;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j) {
      if (stencils_.rows[stencils_.row(j, k)] == 0) continue;
      for (const Rows<Real>& component : u) {
        Real* const row = component(j, k);
        std::copy_n(row + size[0] - velocity_halo, velocity_halo, row - velocity_halo);
        std::copy_n(row, velocity_halo, row + size[0]);
      }
    }
}

template <class Real>
void CoupledSimulation<Real>::interpolate_velocity() {
  interpolate(fluid_.u, walls_, stencils_, cells_.U);
  mesh_mobility_.add(cells_, stencils_.owned);
  timers_.lap(Part::interpolate);
  vertex_exchange_.share(stencils_.owned, cells_.U);
  timers_.lap(Part::halos);
}

template <class Real>
void CoupledSimulation<Real>::advect_vertices() {
  const Advection scheme = setup_.run.parameters.numerics.advection;
  if (counters_.steps_done == 0 && scheme != Advection::euler) start_history(cells_);
  advect(cells_, scheme, fluid_.lattice);
  timers_.lap(Part::advect);
}

template <class Real>
void CoupledSimulation<Real>::restore_volume() {
  volume_shift_.restore(cells_);
  wrap_cells(cells_, fluid_.lattice);
  timers_.lap(Part::volume);
}

template <class Real>
void CoupledSimulation<Real>::track_interior() {
  if (!tracker_) return;
  tracker_->update(cells_, flags_);
  timers_.lap(Part::tracking);
}

template <class Real>
void CoupledSimulation<Real>::correct_interior() {
  const std::int64_t interval = setup_.run.parameters.numerics.correction_interval;
  if (!tracker_ || interval == 0 || counters_.steps_done % interval != 0) return;
  const std::array<Rows<std::uint8_t>, 1> flags{flags_.layout.rows(flags_.data.data())};
  flag_halo_.exchange(flags);
  const Corrections corrections = correction_.apply(flags_);
  counters_.flips += comm_.sum(corrections.activated + corrections.deactivated);
  timers_.lap(Part::correction);
}

template <class Real>
void CoupledSimulation<Real>::resume() {
  cell_record_.unpack(cells_);
  exchange_populations();
}

template <class Real>
PersistentState CoupledSimulation<Real>::persistent() {
  cell_record_.pack(cells_);
  fluid_.f.straighten();
  return state_list(fluid_, flags_, cell_record_, driving_, counters_);
}

template <class Real>
std::int64_t CoupledSimulation<Real>::inside_nodes() const {
  return comm_.sum(count_inside(flags_));
}

template <class Real>
double CoupledSimulation<Real>::mean_velocity() const {
  std::int64_t momentum = 0;
  comm_.all_agree([&] { momentum = momentum_fixed_point(fluid_, 0); });
  return rouleau::mean_velocity(comm_.sum(momentum), fluid_.lattice.nodes(), driving_.force);
}

template class CoupledSimulation<float>;
template class CoupledSimulation<double>;

std::unique_ptr<Simulation> make_simulation(const Setup& setup, const Communicator& comm,
                                            const Decomposition& decomposition) {
  if (setup.run.parameters.numerics.precision == Precision::single_)
    return std::make_unique<CoupledSimulation<float>>(setup, comm, decomposition);
  return std::make_unique<CoupledSimulation<double>>(setup, comm, decomposition);
}

}  // namespace rouleau
