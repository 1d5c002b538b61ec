// SPDX-License-Identifier: BSD-3-Clause
// The manual pages of rouleau-solver, made from the tables of --help and --help-run-file. The same build gives the same
// bytes.
#pragma once

#include <string>

namespace rouleau {

/// rouleau-solver(1), for man(1).
std::string manual_page();

/// rouleau-run-file(5): every parameter.
std::string manual_page_of_run_file();

}  // namespace rouleau
