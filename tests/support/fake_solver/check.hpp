// SPDX-License-Identifier: BSD-3-Clause
// `fake_solver check`: what would be run, share/contract.md section 2.
#pragma once

#include <string>

#include "run_file.hpp"

namespace fake {

/// The JSON object of the contract, one line.
std::string check_json(const RunFile& run);

}  // namespace fake
