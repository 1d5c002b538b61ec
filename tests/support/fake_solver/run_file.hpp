// SPDX-License-Identifier: BSD-3-Clause
// The fake solver's few run parameters, read from the same INI as the real one's.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace fake {

/// Ends the program with this code and line.
struct Failure : std::runtime_error {
  Failure(int exit_code, const std::string& message) : std::runtime_error(message), code(exit_code) {}
  int code;
};

struct Parameter {
  const char* name;
  const char* standard;  ///< "" = required
  bool is_identity;
  bool is_number;
};

const std::vector<Parameter>& parameter_table();

struct RunFile {
  std::map<std::string, std::string> given;  ///< canonical values
  [[nodiscard]] std::string text(const std::string& name) const;
  [[nodiscard]] double number(const std::string& name) const;
  [[nodiscard]] long long steps() const;
};

/// throws Failure 65 "run.ini:LINE: ..."
RunFile read_run_file(const std::string& file);

}  // namespace fake
