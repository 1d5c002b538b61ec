// SPDX-License-Identifier: BSD-3-Clause
// INI text as entries with line numbers, in the dialect that the solver's run file has too.
#pragma once

#include <string>
#include <vector>

namespace rouleau::campaign {

/// `name = value` below `[section]`.
struct IniEntry {
  std::string section;
  std::string name;
  std::string value;
  int line = 0;
};

/// Reads `[section]`, `name = value` and `#` comments (to the end of the line). `file` leads every error.
/// throws Error (usage) for lines that are neither, names outside a section, empty values, and names given twice
[[nodiscard]] std::vector<IniEntry> parse_ini(const std::string& text, const std::string& file);

/// Without blanks at both ends.
[[nodiscard]] std::string trimmed(const std::string& text);

/// The parts between `separator`, each trimmed; one part if there is none.
[[nodiscard]] std::vector<std::string> split(const std::string& text, char separator);

}  // namespace rouleau::campaign
