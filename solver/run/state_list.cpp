// SPDX-License-Identifier: BSD-3-Clause
#include "run/state_list.hpp"

#include <type_traits>

namespace rouleau {

namespace {

/// Pointers to the values; null where only the shapes are wanted.
struct Pointers {
  std::vector<void*> populations;
  void* flags = nullptr;
  ControllerState* controller = nullptr;
  Counters* counters = nullptr;
};

PersistentState list(const Lattice& lattice, const Block& block, ElementType populations,
                     const Layout& population_layout, const Layout& flag_layout, CellRecord& cells, const Pointers& p) {
  using enum ElementType;
  static_assert(sizeof(ControllerState) == 2 * sizeof(double) && sizeof(Counters) == 2 * sizeof(std::int64_t));
  PersistentState state;
  state.lattice = lattice;
  state.block = block;
  state.lattice_items.push_back({"fluid/f", populations, population_layout, p.populations});
  state.lattice_items.push_back({"interior/flags", u8, flag_layout, {p.flags}});
  cells.append_items(state.replicated_items);
  state.replicated_items.push_back({"flow/controller", f64, {2}, p.controller});
  state.replicated_items.push_back({"counters", i64, {2}, p.counters});
  return state;
}

}  // namespace

template <class Real>
PersistentState state_list(Fluid<Real>& fluid, Flags& flags, CellRecord& cells, ControllerState& controller,
                           Counters& counters) {
  Pointers p{{}, flags.data.data(), &controller, &counters};
  for (int q = 0; q < Q; ++q) p.populations.push_back(fluid.f.direction(q));
  constexpr ElementType type = std::is_same_v<Real, float> ? ElementType::f32 : ElementType::f64;
  return list(fluid.lattice, fluid.block, type, fluid.f.layout, flags.layout, cells, p);
}

PersistentState state_shape(const Lattice& lattice, ElementType populations, CellRecord& cells) {
  Pointers p;
  p.populations.resize(Q);
  const Layout layout(lattice.size, 1);
  return list(lattice, {{0, 0, 0}, lattice.size}, populations, layout, layout, cells, p);
}

template PersistentState state_list(Fluid<float>&, Flags&, CellRecord&, ControllerState&, Counters&);
template PersistentState state_list(Fluid<double>&, Flags&, CellRecord&, ControllerState&, Counters&);

}  // namespace rouleau
