// SPDX-License-Identifier: BSD-3-Clause
// The cells as a checkpoint holds them: one contiguous array an item.
#pragma once

#include <vector>

#include "membrane/cells.hpp"
#include "storage/persistent.hpp"

namespace rouleau {

/// Copies between `Cells` (a structure of arrays) and the arrays that stand in the persistent list. Made once for a set
/// of cells.
class CellRecord {
 public:
  explicit CellRecord(const Cells& cells);

  void pack(const Cells& cells);
  /// Sets all that moves: X, U, U_previous, images. Topology and reference are checked by the caller, not taken over.
  void unpack(Cells& cells) const;
  /// Whether topology, reference and volumes agree with these cells, bit for bit.
  [[nodiscard]] bool has_same_mesh(const Cells& cells) const;
  /// XXH3-64 of topology and reference, 16 hex digits.
  [[nodiscard]] std::string mesh_digest() const;

  void append_items(std::vector<ReplicatedItem>& items);

 private:
  std::size_t vertices_, triangles_, cells_;
  std::vector<double> X_, X_reference_, U_, U_previous_, size_;
  std::vector<std::int32_t> corners_, ranges_, images_;
};

}  // namespace rouleau
