// SPDX-License-Identifier: BSD-3-Clause
// Findings as a table for people and as JSON for programs.
#pragma once

#include <span>
#include <string>

#include "suite.hpp"

namespace rouleau::validation {

/// What is shown while the suite runs.
std::string line_of(const Finding& finding);

/// A Markdown table, its columns aligned, and the number of checks that hold.
std::string table_of(std::span<const Finding> findings);

/// A list of objects: case, quantity, ours, reference, tolerance (so that pass is |ours - reference| <= tolerance),
/// expected (the same as text), difference, source, pass, time_s, note. Checks only: figures have no reference. A value
/// that is not a number is null.
std::string json_of(std::span<const Finding> findings);

}  // namespace rouleau::validation
