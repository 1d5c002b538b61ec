// SPDX-License-Identifier: BSD-3-Clause
// Which build this is.
#pragma once

#include <string>

namespace rouleau::campaign {

[[nodiscard]] const char* version();  ///< "0.1.0"
[[nodiscard]] const char*
git_hash();  ///< of the commit built, "-dirty" if the tree differed; "unknown" outside a clone

/// The answer to --version: rouleau, compiler, SQLite, Boost, fmt, nlohmann-json; ended lines.
[[nodiscard]] std::string version_text();

}  // namespace rouleau::campaign
