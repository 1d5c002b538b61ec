// SPDX-License-Identifier: BSD-3-Clause
// A run file as read: typed parameters, and where each value came from.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "run/parameters.hpp"

namespace rouleau {

enum class ParameterKind { identity, free };

/// One parameter of a run, named `section.name` (`cell.2.name` for the second cell).
struct ParameterValue {
  std::string name;
  std::string value;          ///< effective, canonical: numbers in the shortest form that reads back to the same double
  std::string default_value;  ///< canonical; empty when there is none
  std::string identity_value;  ///< what the identity sees: `value`, or for a file the digest of its content
  ParameterKind kind = ParameterKind::identity;
  bool given = false;
  int line = 0;  ///< in the run file; 0 when not given
};

struct RunFile {
  std::filesystem::path path;
  RunParameters parameters;
  std::vector<ParameterValue> values;  ///< every parameter, in the order of the table
  std::string identity;                ///< 32 hex digits (share/contract.md section 2)

  /// `run.ini:12` for a parameter that was given, `run.ini` for one at its default.
  [[nodiscard]] std::string where(std::string_view name) const;
  /// The parameter of this name. Throws std::logic_error if there is none.
  [[nodiscard]] const ParameterValue& value(std::string_view name) const;
};

/// Reads a run file, at most 1 MiB.
/// throws Error(bad_input) `run.ini:LINE: ...` for anything unknown, missing, mistyped, out of range or unused, and
/// when the file cannot be read
RunFile read_run_file(const std::filesystem::path& path);

/// The same from text already read; `path` names the file in messages and is the base of relative paths in it.
RunFile parse_run_file(std::string_view text, const std::filesystem::path& path);

}  // namespace rouleau
