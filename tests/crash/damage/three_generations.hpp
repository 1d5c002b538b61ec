// SPDX-License-Identifier: BSD-3-Clause
// A finished small run with three generations, whose files can be damaged and put back.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "restart/small_run.hpp"

namespace rouleau::testing {

class ThreeGenerations {
 public:
  static constexpr int steps[] = {20, 40, 60};
  /// Runs it to the end in three parts.
  ThreeGenerations();

  SmallRun run;
  /// Puts every file back as it was at the end, and forgets all attempts.
  void put_back() const;
  /// The bytes of a file at the end.
  [[nodiscard]] const std::string& sound(const std::string& name) const { return sound_.at(name); }
  [[nodiscard]] static std::string checkpoint(int generation);
  /// Bytes of the log that a generation counts.
  [[nodiscard]] std::size_t counted(int generation) const { return counted_.at(static_cast<std::size_t>(generation)); }

  /// Whether last state and samples are those of the undisturbed run.
  [[nodiscard]] bool has_the_same_end() const;
  /// Whether no file has changed, but for new attempts.
  [[nodiscard]] bool is_untouched() const;

 private:
  [[nodiscard]] std::map<std::string, std::string> files() const;
  [[nodiscard]] std::string digest(const std::string& checkpoint) const;
  std::map<std::string, std::string> sound_;
  std::vector<std::size_t> counted_;
  std::string digest_;
};

}  // namespace rouleau::testing
