// SPDX-License-Identifier: BSD-3-Clause
// Running another program to its end from within a program that may have started MPI.
#pragma once

#include <string>
#include <vector>

namespace rouleau::validation {

/// Keeps the environment as it is now for programs to come: MPI adds to it, and a solver that inherits that takes
/// itself for a part of this program. Call it before MPI is started; without it programs get the present environment.
void keep_environment();

struct Ended {
  int status = 0;   ///< exit status; 128 + signal if a signal ended it
  std::string out;  ///< what it printed on stdout; stderr is this program's
};

/// `words`: the program, then its arguments. Standard input is empty.
/// throws Error(io) if it cannot be started
Ended run_program(const std::vector<std::string>& words);

}  // namespace rouleau::validation
