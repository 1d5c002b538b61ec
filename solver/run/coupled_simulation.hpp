// SPDX-License-Identifier: BSD-3-Clause
// The coupled simulation: fluid, membranes and flag lattice of one rank, and the step that advances them.
#pragma once

#include <optional>
#include <span>

#include "coupling/advect.hpp"
#include "coupling/interpolate.hpp"
#include "coupling/mesh_mobility.hpp"
#include "coupling/reach.hpp"
#include "coupling/stencils.hpp"
#include "fluid/collide.hpp"
#include "fluid/controller.hpp"
#include "interior/correction.hpp"
#include "interior/tracker.hpp"
#include "membrane/fold_resistance.hpp"
#include "membrane/membrane_forces.hpp"
#include "membrane/mesh_health.hpp"
#include "membrane/stretch.hpp"
#include "membrane/volume.hpp"
#include "parallel/halo.hpp"
#include "parallel/vertex_exchange.hpp"
#include "run/cell_record.hpp"
#include "run/simulation.hpp"
#include "run/state_list.hpp"

namespace rouleau {

template <class Real>
class CoupledSimulation final : public Simulation {
 public:
  CoupledSimulation(const Setup& setup, const Communicator& comm, const Decomposition& decomposition);

  void start() override;
  void resume() override;
  void step() override;
  PersistentState persistent() override;
  [[nodiscard]] std::string mesh_digest() const override { return cell_record_.mesh_digest(); }

  [[nodiscard]] std::int64_t steps_done() const override { return counters_.steps_done; }
  [[nodiscard]] const Cells& cells() const override { return cells_; }
  [[nodiscard]] const StepTimers& timers() const override { return timers_; }
  [[nodiscard]] std::int64_t inside_nodes() const override;
  [[nodiscard]] double mean_velocity() const override;
  [[nodiscard]] double body_force() const override { return driving_.force; }
  [[nodiscard]] std::int64_t flips() const override { return counters_.flips; }
  void forget_flips() override { counters_.flips = 0; }
  void check_health() override;
  void find_membrane_forces() override;
  LatticePicture take_picture(int stride) override;

 private:
  // The verbs of the step, in its order.
  void hold_mean_velocity();
  void compute_membrane_forces();
  void spread_forces();
  void move_fluid();
  void interpolate_velocity();
  void advect_vertices();
  void restore_volume();
  void track_interior();
  void correct_interior();

  void sum_membrane_forces(std::span<const std::uint8_t> needed);
  void start_fluid();
  void start_flags();
  void exchange_populations();
  void exchange_velocity();
  void close_velocity_rows(const std::array<Rows<Real>, 3>& u);
  void check_flow() const;
  void check_cells();

  const Setup& setup_;
  const Communicator& comm_;
  Fluid<Real> fluid_;
  Collision collision_;
  Flags flags_;
  Cells cells_;
  CellRecord cell_record_;
  ReachAlongX reach_;
  Stencils stencils_;
  WallVelocities walls_;
  MembraneForces forces_;
  FoldResistance fold_resistance_;
  std::optional<Stretch> stretch_;  ///< none: nothing pulls at the cells
  MeshHealth mesh_health_;
  VolumeShift volume_shift_;
  MeshMobility mesh_mobility_;
  std::optional<Tracker> tracker_;  ///< none: tracking is off
  Correction correction_;
  std::optional<MeanVelocityController> controller_;  ///< none: the force is fixed
  ControllerState driving_;

  HaloExchange<Real> population_halo_, velocity_halo_;
  typename HaloExchange<Real>::Components crossing_;  ///< the populations that cross each face
  HaloExchange<std::uint8_t> flag_halo_;
  VertexExchange vertex_exchange_;

  Counters counters_;
  StepTimers timers_;
};

}  // namespace rouleau
