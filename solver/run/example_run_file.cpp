// SPDX-License-Identifier: BSD-3-Clause
// The example run file that the parameter table writes.
#include <algorithm>

#include "base/error.hpp"
#include "run/parameter_table.hpp"
#include "run/value_text.hpp"

namespace rouleau {
namespace {

std::string allowed(const ParameterSpec& p) {
  if (p.type == ParameterType::choice) return fmt::format("{}", fmt::join(p.choices, " | "));
  if (p.type == ParameterType::file) return "a path";
  const std::string range = canonical(p.min) + " to " + canonical(p.max);
  if (p.type == ParameterType::vector) return "three numbers, " + range;
  return p.type == ParameterType::integer ? "whole number, " + range : range;
}

std::string needs(const ParameterSpec& p) {
  std::string text;
  for (const auto& c : p.conditions)
    if (c.selector != "cells") text += fmt::format("; with {} = {}", c.selector, fmt::join(c.admitted, "|"));
  return text;
}

bool applies_by_default(const ParameterSpec& p) {
  const auto table = parameter_table();
  return std::all_of(p.conditions.begin(), p.conditions.end(), [&](const Condition& c) {
    if (c.selector == "cells") return true;
    const auto selector = std::find_if(table.begin(), table.end(), [&](const ParameterSpec& q) {
      return q.section == p.section && q.name == c.selector;
    });
    return std::find(c.admitted.begin(), c.admitted.end(), selector->default_text) != c.admitted.end();
  });
}

}  // namespace

std::string example_run_file() {
  std::string text =
      "# A run file of rouleau-solver: this one works as it stands. `rouleau-solver check run.ini` shows what it "
      "means.\n"
      "# Every parameter is listed with its allowed values and its default; a line that begins with `#` is a comment, "
      "so\n"
      "# the commented parameters are at their defaults. Numbers may be fractions (1/3). Parameters marked free may "
      "change\n"
      "# when a run is continued, all others define the run.\n";
  std::string_view section;
  for (const ParameterSpec& p : parameter_table()) {
    if (p.section != section) {
      text += fmt::format("\n[{}]\n", p.section);
      section = p.section;
      if (section == "cell")
        text += "# Further cells: sections [cell.2], [cell.3] ... with the same names; shape must be given there.\n";
    }
    const std::string default_note = p.default_text.empty() ? "" : fmt::format("; default {}", p.default_text);
    text += fmt::format("# {}\n#   {}{}{}{}\n", p.help, allowed(p), default_note,
                        p.kind == ParameterKind::free ? "; free" : "", needs(p));
    const bool active = !p.example.empty() && applies_by_default(p);
    text += fmt::format("{}{} = {}\n", active ? "" : "#", p.name, p.example.empty() ? p.default_text : p.example);
  }
  return text;
}

}  // namespace rouleau
