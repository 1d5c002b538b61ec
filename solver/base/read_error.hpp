// SPDX-License-Identifier: BSD-3-Clause
// What it means that a file which the user named cannot be opened or read.
#pragma once

#include <cerrno>

#include "base/error.hpp"

namespace rouleau {

/// Of an errno: the file is not there, which stays so, or something is wrong with the file system, which may pass.
inline Exit exit_of_read(int error) { return error == ENOENT || error == ENOTDIR ? Exit::bad_input : Exit::io; }

}  // namespace rouleau
