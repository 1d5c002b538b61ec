// SPDX-License-Identifier: BSD-3-Clause
// Names all that survives a step of the coupled simulation.
#pragma once

#include <cstdint>

#include "fluid/controller.hpp"
#include "fluid/fluid.hpp"
#include "interior/flags.hpp"
#include "run/cell_record.hpp"
#include "storage/persistent.hpp"

namespace rouleau {

/// What the simulation counts, as it stands in a checkpoint.
struct Counters {
  std::int64_t steps_done = 0;
  std::int64_t flips = 0;  ///< by corrections since the last sample
};

/// The list. Its pointers are valid until a step (which swaps population arrays) or a change of the arguments.
template <class Real>
PersistentState state_list(Fluid<Real>& fluid, Flags& flags, CellRecord& cells, ControllerState& controller,
                           Counters& counters);

/// The same list without values, all of the lattice in one block: for size estimates.
PersistentState state_shape(const Lattice& lattice, ElementType populations, CellRecord& cells);

extern template PersistentState state_list(Fluid<float>&, Flags&, CellRecord&, ControllerState&, Counters&);
extern template PersistentState state_list(Fluid<double>&, Flags&, CellRecord&, ControllerState&, Counters&);

}  // namespace rouleau
