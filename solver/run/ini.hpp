// SPDX-License-Identifier: BSD-3-Clause
// An INI text as entries that know their lines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rouleau {

struct IniEntry {
  std::string section, name, value;
  int line = 0;
};

struct IniSection {
  std::string name;
  int line = 0;
};

struct Ini {
  std::vector<IniSection> sections;  ///< in the order of the text, each once
  std::vector<IniEntry> entries;     ///< in the order of the text, each (section, name) once
  int lines = 0;
};

/// Splits the text; `source` names it in messages. A byte order mark and CRLF line ends are accepted; a `#` begins a
/// comment anywhere; a value may stand in double quotes. throws Error(bad_input) `source:LINE: ...` for bytes that are
/// no text, entries before the first section, repeated sections and names, and lines that are none of section, `name =
/// value`, comment
Ini read_ini(std::string_view text, const std::string& source);

}  // namespace rouleau
