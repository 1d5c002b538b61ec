// SPDX-License-Identifier: BSD-3-Clause
// The table of contents of a checkpoint: name, type, shape and checksums of every item.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/vec3.hpp"
#include "parallel/communicator.hpp"
#include "storage/persistent.hpp"

namespace rouleau {

struct ManifestItem {
  std::string name;
  bool on_lattice = false;
  ElementType type{};
  std::vector<std::uint64_t> shape;      ///< on the lattice: component, z, y, x
  std::vector<std::uint64_t> checksums;  ///< one a component on the lattice, else one in all
  bool operator==(const ManifestItem&) const = default;
};

struct Manifest {
  int layout = 0;
  Int3 lattice{};
  std::vector<ManifestItem> items;
  std::uint64_t metadata_checksum = 0;
  bool operator==(const Manifest&) const = default;
};

/// Names, types and shapes of a state; checksums are left empty.
[[nodiscard]] Manifest describe(const PersistentState& state);

/// Same with the checksums of the values in memory. Collective.
/// throws  Error(physics) on all ranks if a replicated item differs between ranks: one of them has computed wrongly
[[nodiscard]] Manifest take_checksums(const PersistentState& state, const Communicator& comm);

/// JSON text, keys and items in a fixed order, and back. Reading checks every entry and bounds every size before it is
/// used. throws  Error(bad_input) naming `file`
[[nodiscard]] std::string to_json(const Manifest& manifest);
[[nodiscard]] Manifest manifest_from_json(const std::string& text, const std::string& file);

/// 32 hex digits over the items: names, types, shapes, checksums.
[[nodiscard]] std::string digest(const Manifest& manifest);

/// Bytes of an item's values; throws Error(bad_input) naming `file` if the product does not fit into 63 bits.
[[nodiscard]] std::uint64_t item_bytes(const ManifestItem& item, const std::string& file);

}  // namespace rouleau
