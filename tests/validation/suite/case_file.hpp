// SPDX-License-Identifier: BSD-3-Clause
// The input file of a case that runs in this program: an INI text whose every entry must be used.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "run/ini.hpp"

namespace rouleau::validation {

class CaseFile {
 public:
  /// throws Error(bad_input), Error(io)
  explicit CaseFile(const std::filesystem::path& path);

  /// A number or fraction.
  /// throws Error(bad_input) naming file and line, if it is missing or no number
  [[nodiscard]] double number(const std::string& section, const std::string& name);
  [[nodiscard]] int integer(const std::string& section, const std::string& name);
  /// Numbers separated by commas, at least one.
  [[nodiscard]] std::vector<double> numbers(const std::string& section, const std::string& name);

  /// throws Error(bad_input) naming the first entry that nobody asked for
  void require_all_used() const;

 private:
  const IniEntry& find(const std::string& section, const std::string& name);
  [[nodiscard]] double parse(const IniEntry& entry, const std::string& text) const;

  std::string name_;
  Ini ini_;
  std::set<int> used_lines_;
};

}  // namespace rouleau::validation
