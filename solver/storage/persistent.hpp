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

/// Bytes of one element.
[[nodiscard]] constexpr std::size_t element_size(ElementType type) {
  switch (type) {
    case ElementType::u8:
      return 1;
    case ElementType::f32:
    case ElementType::i32:
      return 4;
    case ElementType::f64:
    case ElementType::i64:
      return 8;
  }
  return 0;
}

/// "f32", "f64", "u8", "i32", "i64".
[[nodiscard]] const char* element_name(ElementType type);

/// Values on the lattice, one block a rank: `data[c]` is component c in `layout`. On file: [component][z][y][x],
/// global.
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

/// Names are paths such as "fluid/f" (letters, digits, '_' and '/'), each used once. An item with no elements is
/// allowed.
struct PersistentState {
  Lattice lattice;
  Block block;
  std::vector<LatticeItem> lattice_items;
  std::vector<ReplicatedItem> replicated_items;
};

/// Number of elements of a replicated item.
[[nodiscard]] std::size_t element_count(const ReplicatedItem& item);

/// Bytes of a checkpoint of this state, all ranks' blocks together: an upper bound within 64 KiB plus the metadata's
/// size.
[[nodiscard]] std::uint64_t estimate_bytes(const PersistentState& state);

/// Checks what the list promises: names, pointers, block inside the lattice, layouts of the block's size. Throws
/// logic_error.
void require_well_formed(const PersistentState& state);

/// Throws Error(physics) naming the first value of this rank that is not finite: item, component, global node or
/// element.
void require_finite(const PersistentState& state, std::int64_t step);

}  // namespace rouleau
