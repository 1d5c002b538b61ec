// SPDX-License-Identifier: BSD-3-Clause
// The verbs that look and change nothing: check, inspect, verify.
#pragma once

#include <filesystem>
#include <string>

#include "base/error.hpp"
#include "storage/file_system.hpp"

namespace rouleau {

/// What `run_file` would run, as text or as the JSON object of share/contract.md section 2.
std::string check_text(const std::filesystem::path& run_file, bool json, FileSystem& files);

/// What a checkpoint holds. throws Error(bad_input) if it is damaged
std::string inspect_text(const std::filesystem::path& file, bool json, FileSystem& files);

struct VerifyAnswer {
  bool sound = false;
  std::string text;
};

/// Every byte of a checkpoint against its checksums.
VerifyAnswer verify_text(const std::filesystem::path& file, FileSystem& files);

}  // namespace rouleau
