// SPDX-License-Identifier: BSD-3-Clause
// The coupled simulation as the run loop sees it: start or resume, step, measure, persist.
#pragma once

#include <memory>

#include "membrane/cells.hpp"
#include "parallel/decomposition.hpp"
#include "run/lattice_picture.hpp"
#include "run/setup.hpp"
#include "run/timers.hpp"
#include "storage/persistent.hpp"

namespace rouleau {

/// One rank's share of a simulation, whatever the precision of its populations. "Collective": all ranks call it, all
/// get the same answer or the same Error.
class Simulation {
 public:
  virtual ~Simulation() = default;

  /// Initial state: fluid, cells, flags. Collective.
  virtual void start() = 0;
  /// After the arrays of `persistent()` were loaded: takes them over and rebuilds what is not stored. Collective.
  virtual void resume() = 0;
  /// One time step. Collective. throws Error(physics) if the mesh or the flow has lost its meaning
  virtual void step() = 0;

  /// The list of all that survives a step, refreshed from the working arrays; valid until the next step.
  virtual PersistentState persistent() = 0;
  /// Of the cells' topology and stress-free shapes.
  [[nodiscard]] virtual std::string mesh_digest() const = 0;

  [[nodiscard]] virtual std::int64_t steps_done() const = 0;
  [[nodiscard]] virtual const Cells& cells() const = 0;
  [[nodiscard]] virtual const StepTimers& timers() const = 0;
  /// Nodes flagged inside. Collective.
  [[nodiscard]] virtual std::int64_t inside_nodes() const = 0;
  /// Mean velocity along x over all nodes, lattice units. Collective.
  [[nodiscard]] virtual double mean_velocity() const = 0;
  /// Body force along x in the last step, lattice units.
  [[nodiscard]] virtual double body_force() const = 0;
  /// Flags changed by corrections since the last call of `forget_flips`, on all ranks.
  [[nodiscard]] virtual std::int64_t flips() const = 0;
  virtual void forget_flips() = 0;
  /// Throws Error(physics) if values are not finite, a triangle is folded or collapsed, area or inside-node count is
  /// out of bounds, or the flow is too fast. Collective.
  virtual void check_health() = 0;

  /// Makes cells().F of all vertices those of the present positions, as the next step will find them. They follow from
  /// the persistent state alone, and no later step sees that they were asked for. Collective.
  virtual void find_membrane_forces() = 0;
  /// The fields at every `stride`-th node, with the forces of find_membrane_forces. Collective; rank 0's, empty
  /// elsewhere.
  virtual LatticePicture take_picture(int stride) = 0;
};

/// Makes the simulation in the precision that the run file asks for. `setup` and `comm` must outlive it. Collective.
std::unique_ptr<Simulation> make_simulation(const Setup& setup, const Communicator& comm,
                                            const Decomposition& decomposition);

}  // namespace rouleau
