// SPDX-License-Identifier: BSD-3-Clause
// The one table of all parameters of a run file: name (with its unit), type, default, range, kind, help, condition.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "run/parameters.hpp"
#include "run/run_file.hpp"

namespace rouleau {

enum class ParameterType { real, integer, choice, vector, file };

/// A parameter that only means something for some choices of another one.
struct Condition {
  std::string_view selector;  ///< a choice in the same section, `section.name`; or `cells`: at least one cell
  std::vector<std::string_view> admitted;  ///< choices of the selector; empty for `cells`
};

/// A value as read: the member of the parameter's type counts.
struct TypedValue {
  double real = 0;
  std::int64_t integer = 0;
  std::size_t choice = 0;
  Vec3 vector = Vec3::Zero();
  std::filesystem::path file;
};

struct ParameterSpec {
  std::string_view section;
  std::string_view name;
  ParameterType type;
  std::string_view
      default_text;  ///< as a user would write it; empty: required where it applies (but see position_x_um, frequency)
  double min, max;   ///< closed range of numbers and of each component
  ParameterKind kind;
  std::vector<std::string_view> choices;
  std::vector<Condition> conditions;  ///< all must hold
  std::string_view example;  ///< value of a required parameter in the example run file; empty: shown as a comment
  std::string_view help;
  void (*store)(RunParameters&, std::size_t cell, const TypedValue&);

  [[nodiscard]] std::string full_name() const;
};

std::span<const ParameterSpec> parameter_table();

/// The help of --help-run-file: a valid run file with every parameter, its help, range and default as comments.
std::string example_run_file();

}  // namespace rouleau
