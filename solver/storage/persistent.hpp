// SPDX-License-Identifier: BSD-3-Clause
// The list of everything that survives a step. Checkpoint, digest, comparison and size estimate all walk this list.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/grid.hpp"

namespace rouleau {

enum class ElementType { f32, f64, u8, i32, i64 };

/// Values on the lattice, one block a rank: `data[c]` is component c in `layout`. On file: [component][z][y][x], global.
struct LatticeItem {
  std::string name;
  ElementType type;
  Layout layout;
  std::vector<void*> data;
};

/// Values that every rank holds alike (vertices, controller, sampler). On file: as shaped here; rank 0's are written.
struct ReplicatedItem {
  std::string name;
  ElementType type;
  std::vector<std::size_t> shape;
  void* data;
};

struct PersistentState {
  Lattice lattice;
  Block block;
  std::vector<LatticeItem> lattice_items;
  std::vector<ReplicatedItem> replicated_items;
};

}  // namespace rouleau
