// SPDX-License-Identifier: BSD-3-Clause
// One start of the solver on a run directory, and whether it is still the newest (share/contract.md sections 1 and 8).
#pragma once

#include <filesystem>
#include <string>

#include "storage/file_system.hpp"

namespace rouleau {

/// Serial: rank 0 holds it, inside Communicator::on_root.
class Attempt {
 public:
  /// Takes the next free number in `<run>/attempts`, with a random token: a start by hand.
  static Attempt claim(FileSystem& files, const std::filesystem::path& run_directory);

  /// Takes part in the attempt that a manager made.
  /// throws  Error(usage) if attempts/<number>/owner is missing; Error(superseded) if it holds another token or a newer
  /// attempt
  ///         exists
  static Attempt join(FileSystem& files, const std::filesystem::path& run_directory, int number,
                      const std::string& token);

  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] const std::string& token() const { return token_; }
  [[nodiscard]] std::filesystem::path directory() const;  ///< attempts/<k>
  [[nodiscard]] const std::filesystem::path& run_directory() const { return run_; }

  /// Highest number in attempts/, and our token in owner. Throws Error(io) if the directory cannot be read.
  [[nodiscard]] bool is_newest() const;
  /// Throws Error(superseded) unless is_newest().
  void fence() const;

 private:
  Attempt(FileSystem& files, std::filesystem::path run, int number, std::string token);
  /// Leaves older attempts nothing to rename (unfinished.hpp). Before anything else is read.
  void disarm_older() const;
  FileSystem* files_;
  std::filesystem::path run_;
  int number_;
  std::string token_;
};

/// Whether attempts/<number>/owner holds this token. Another's folder is not to be written to.
[[nodiscard]] bool owns_attempt(FileSystem& files, const std::filesystem::path& run_directory, int number,
                                const std::string& token);

/// The highest attempt number in `<run>/attempts`; 0 if there is none.
[[nodiscard]] int newest_attempt(FileSystem& files, const std::filesystem::path& run_directory);

}  // namespace rouleau
