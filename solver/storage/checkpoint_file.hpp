// SPDX-License-Identifier: BSD-3-Clause
// A checkpoint file opened for reading: its texts checked on opening, its values on request.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/grid.hpp"
#include "storage/hdf5_driver.hpp"
#include "storage/hdf5_handle.hpp"
#include "storage/manifest.hpp"
#include "storage/metadata.hpp"

namespace rouleau {

/// Every rank opens the file for itself; nothing here is collective. Check the seal (seal.hpp) first.
/// Every function throws Error(bad_input) naming the file if what it finds is not what the manifest says, and Error(io)
/// if it cannot be read.
class CheckpointFile {
 public:
  CheckpointFile(FileSystem& files, const std::filesystem::path& path);

  /// False if the file has another layout version: then only metadata().layout, version and git are known.
  [[nodiscard]] bool readable() const { return metadata_.layout == checkpoint_layout; }
  [[nodiscard]] const Manifest& manifest() const { return manifest_; }
  [[nodiscard]] const CheckpointMetadata& metadata() const { return metadata_; }
  [[nodiscard]] const ManifestItem* find(const std::string& name) const;

  /// The nodes of `block` of one component, x fastest, without gaps: block.size[0] * size[1] * size[2] elements.
  void read_block(const ManifestItem& item, std::size_t component, const Block& block, void* packed) const;
  /// All values of an item that is not on the lattice.
  void read_all(const ManifestItem& item, void* values) const;

 private:
  [[nodiscard]] std::string read_text(const char* name, std::uint64_t longest) const;
  [[nodiscard]] hdf5::Handle open_dataset(const ManifestItem& item) const;
  template <class T>
  T check(T value, const std::string& what) const;
  std::string name_;
  std::unique_ptr<hdf5::Ground> ground_;
  hdf5::Handle file_;
  Manifest manifest_;
  CheckpointMetadata metadata_;
};

/// Number of nodes in a block.
[[nodiscard]] std::size_t node_count(const Block& block);

}  // namespace rouleau
