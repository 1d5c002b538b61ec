// SPDX-License-Identifier: BSD-3-Clause
// What makes two run files the same point: a digest of their parameters, and of the content of the files they name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "run/run_file.hpp"

namespace rouleau {

/// XXH3-128 of a file's bytes as 32 hex digits; throws  Error with the bare reason if it cannot be
/// read: bad_input if it is not there or no file, else io.
std::string content_digest(const std::filesystem::path& file);

/// Digest over the identity parameters that differ from their defaults: XXH3-128 of the lines `name=identity_value\n`,
/// sorted by name, as 32 hex digits. A default that is named, or a new parameter at its default, changes nothing.
std::string identity_digest(const std::vector<ParameterValue>& values);

}  // namespace rouleau
