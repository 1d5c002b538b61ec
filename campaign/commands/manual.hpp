// SPDX-License-Identifier: BSD-3-Clause
// The manual pages, made from the tables of --help.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "commands/cli.hpp"

namespace rouleau::campaign {

/// "rouleau" (section 1: all verbs), "study" and "cluster" (section 5: the two files).
[[nodiscard]] std::vector<std::string> manual_page_names();

/// A page for man(1). The same build gives the same bytes.   throws Error (usage) if there is no page of that name
[[nodiscard]] std::string manual_page(std::span<const Verb* const> verbs, const std::string& name);

}  // namespace rouleau::campaign
