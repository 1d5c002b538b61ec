// SPDX-License-Identifier: BSD-3-Clause
// Questions that only need the list of persistent items: sizes, soundness, finite values.
#include "storage/persistent.hpp"

#include <cmath>
#include <set>

#include "base/error.hpp"

namespace rouleau {
namespace {

// Superblock, groups, object headers, manifest: about 400 bytes an item and 30 a component.
constexpr std::uint64_t file_overhead = 65536;

std::uint64_t lattice_bytes(const PersistentState& state, const LatticeItem& item) {
  return static_cast<std::uint64_t>(state.lattice.nodes()) * item.data.size() * element_size(item.type);
}

bool well_named(const std::string& name) {
  const bool letters =
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_/") == std::string::npos;
  const bool reserved = name == "metadata" || name == "manifest" || name == "manifest_checksum";
  const bool slashes = !name.empty() && name.front() != '/' && name.back() != '/';
  return letters && slashes && !reserved && name.find("//") == std::string::npos;
}

template <class Real>
void require_finite_block(const LatticeItem& item, std::size_t component, const Block& block, std::int64_t step) {
  const auto* values = static_cast<const Real*>(item.data[component]);
  for (int k = 0; k < block.size[2]; ++k) {
    for (int j = 0; j < block.size[1]; ++j) {
      const Real* row = values + item.layout.index(0, j, k);
      // x - x is 0 for finite x and not a number otherwise: a sum that vectorises without a branch a node.
      Real doubt = 0;
      for (int i = 0; i < block.size[0]; ++i) doubt += row[i] - row[i];
      if (doubt == Real{0}) continue;
      for (int i = 0; i < block.size[0]; ++i) {
        if (std::isfinite(row[i])) continue;
        fail(Exit::physics,
             "step {}: {} component {} is not finite ({}) at node ({}, {}, {}); no checkpoint was written. "
             "Try a smaller time step.",
             step, item.name, component, row[i], block.begin[0] + i, block.begin[1] + j, block.begin[2] + k);
      }
    }
  }
}

template <class Real>
void require_finite_elements(const ReplicatedItem& item, std::int64_t step) {
  const auto* values = static_cast<const Real*>(item.data);
  const std::size_t count = element_count(item);
  for (std::size_t i = 0; i < count; ++i) {
    if (std::isfinite(values[i])) continue;
    fail(Exit::physics,
         "step {}: {} is not finite ({}) at element {} of {}; no checkpoint was written. Try a smaller time step.",
         step, item.name, values[i], i, count);
  }
}

}  // namespace

const char* element_name(ElementType type) {
  switch (type) {
    case ElementType::f32:
      return "f32";
    case ElementType::f64:
      return "f64";
    case ElementType::u8:
      return "u8";
    case ElementType::i32:
      return "i32";
    case ElementType::i64:
      return "i64";
  }
  return "?";
}

std::size_t element_count(const ReplicatedItem& item) {
  std::size_t count = 1;
  for (const std::size_t n : item.shape) count *= n;
  return count;
}

std::uint64_t estimate_bytes(const PersistentState& state) {
  std::uint64_t bytes = file_overhead;
  for (const LatticeItem& item : state.lattice_items) bytes += 512 + 32 * item.data.size() + lattice_bytes(state, item);
  for (const ReplicatedItem& item : state.replicated_items)
    bytes += 512 + element_count(item) * element_size(item.type);
  return bytes;
}

void require_well_formed(const PersistentState& state) {
  std::set<std::string> names;
  const Block& block = state.block;
  for (int axis = 0; axis < 3; ++axis) {
    require(state.lattice.size[axis] > 0, "persistent state: the lattice is empty");
    require(block.begin[axis] >= 0 && block.size[axis] >= 0, "persistent state: the block is negative");
    require(block.begin[axis] + block.size[axis] <= state.lattice.size[axis],
            "persistent state: the block leaves the lattice");
  }
  for (const LatticeItem& item : state.lattice_items) {
    require(well_named(item.name) && names.insert(item.name).second, "persistent state: bad or repeated item name");
    require(item.layout.size == block.size, "persistent state: an item's layout differs from the block");
    require(!item.data.empty(), "persistent state: a lattice item without components");
    for (const void* data : item.data) require(data != nullptr, "persistent state: a component without data");
  }
  for (const ReplicatedItem& item : state.replicated_items) {
    require(well_named(item.name) && names.insert(item.name).second, "persistent state: bad or repeated item name");
    require(!item.shape.empty(), "persistent state: a replicated item without a shape");
    require(item.data != nullptr || element_count(item) == 0, "persistent state: an item without data");
  }
}

void require_finite(const PersistentState& state, std::int64_t step) {
  for (const LatticeItem& item : state.lattice_items) {
    for (std::size_t c = 0; c < item.data.size(); ++c) {
      if (item.type == ElementType::f32) require_finite_block<float>(item, c, state.block, step);
      if (item.type == ElementType::f64) require_finite_block<double>(item, c, state.block, step);
    }
  }
  for (const ReplicatedItem& item : state.replicated_items) {
    if (item.type == ElementType::f32) require_finite_elements<float>(item, step);
    if (item.type == ElementType::f64) require_finite_elements<double>(item, step);
  }
}

}  // namespace rouleau
