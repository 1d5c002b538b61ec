// SPDX-License-Identifier: BSD-3-Clause
// A disk that loses power: what recorded calls have changed, and what of it is sure to be there afterwards.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>

#include "support/fault_shim/call_log.hpp"

namespace rouleau::testing {

/// What a loss of power leaves. POSIX promises the content of a file that was synced since, and the names in a
/// directory that was synced since; the rest may be there or not.
enum class Loss {
  nothing,      ///< everything is there: as after a kill
  all_pending,  ///< nothing that was not synced is there
  data,         ///< all names are there, but no data that was not synced: as ext4 with delayed allocation may leave it
  names,        ///< all data is there, but no name, rename or removal that was not synced
  mixed,        ///< of each name and each file by lot; of data perhaps the blocks in front only
};

class DiskModel {
 public:
  /// Begins with what lies below a directory, all of it synced.
  explicit DiskModel(std::filesystem::path root);

  void apply(const RecordedCall& call);

  /// Makes `target` what the directory is after the loss. `seed` draws the lots of a mixed one.
  void restore(Loss loss, const std::filesystem::path& target, std::uint64_t seed = 0) const;
  /// The files with their content, by the path below the directory, before any loss.
  [[nodiscard]] std::map<std::string, std::string> files() const;

 private:
  struct Node {
    bool is_directory = false;
    std::shared_ptr<const std::string> data, synced_data;  ///< of a file
    std::map<std::string, std::shared_ptr<Node>> entries, synced_entries;
  };
  using NodePointer = std::shared_ptr<Node>;

  [[nodiscard]] NodePointer find(const std::string& path) const;
  [[nodiscard]] Node& parent_of(const std::string& path) const;
  static NodePointer read(const std::filesystem::path& path);
  static void write(const Node& node, Loss loss, std::mt19937_64& lots, const std::filesystem::path& target);
  static void collect(const Node& node, const std::string& prefix, std::map<std::string, std::string>& found);

  std::filesystem::path root_path_;
  NodePointer root_;
};

}  // namespace rouleau::testing
